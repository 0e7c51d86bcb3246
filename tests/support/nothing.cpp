// A program that does nothing: it shows that what it is linked with is complete.

int main() { return 0; }

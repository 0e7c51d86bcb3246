# Install rules and the package that find_package(armlet) finds.

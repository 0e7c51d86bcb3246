local function makeText(words)
    local syllables = {[0] = "ka", "lo", "mi", "ne", "ru", "sta", "ven", "zo"}
    local parts = {}
    local state = 5
    for w = 0, words - 1 do
        state = (state * 1103515245 + 12345) % 2147483648
        local count = 1 + state // 65536 % 3
        for s = 0, count - 1 do
            state = (state * 1103515245 + 12345) % 2147483648
            parts[#parts + 1] = syllables[state // 65536 % 8]
        end
        parts[#parts + 1] = " "
    end
    return table.concat(parts)
end
local text = makeText(60000)
local counts = {}
for k = 0, 25 do counts[k] = 0 end
local words, longest, current, vowels = 0, 0, 0, 0
local sub = string.sub
for i = 1, #text do
    local c = sub(text, i, i)
    if c == " " then
        words = words + 1
        if current > longest then longest = current end
        current = 0
    else
        current = current + 1
        local at = string.byte(c) - string.byte("a")
        counts[at] = counts[at] + 1
        if c == "a" or c == "e" or c == "i" or c == "o" or c == "u" then vowels = vowels + 1 end
    end
end
local palindromes = 0
for i = 3, #text - 2 do
    if sub(text, i - 1, i - 1) == sub(text, i + 1, i + 1) and sub(text, i - 2, i - 2) == sub(text, i + 2, i + 2) then
        palindromes = palindromes + 1
    end
end
print(words, longest, vowels, palindromes, #text)
for k = 0, 25 do print(counts[k]) end

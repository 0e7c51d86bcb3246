local function reversed(s)
    local out = {}
    for i = #s, 1, -1 do out[#out + 1] = s:sub(i, i) end
    return table.concat(out)
end
local function caesar(s, shift)
    local out = {}
    for i = 1, #s do
        local code = string.byte(s:sub(i, i))
        if code >= 97 and code <= 122 then
            out[#out + 1] = string.char(97 + (code - 97 + shift) % 26)
        else
            out[#out + 1] = s:sub(i, i)
        end
    end
    return table.concat(out)
end
local function isPalindrome(s)
    local i = 1
    local j = #s
    while i < j do
        if s:sub(i, i) ~= s:sub(j, j) then return false end
        i = i + 1
        j = j - 1
    end
    return true
end
local function binary(n)
    local text = ""
    local rest = n
    while rest > 0 do
        text = tostring(rest % 2) .. text
        rest = rest // 2
    end
    return text
end
local sentence = "the quick brown fox jumps over the lazy dog"
local length = 0
for k = 0, 3999 do
    local turned = reversed(sentence)
    local coded = caesar(turned, k % 26)
    length = length + #coded
    if coded == sentence then length = length + 1 end
end
local count = 0
for i = 1, 29999 do
    if isPalindrome(binary(i)) then count = count + 1 end
end
print(length, count, caesar(reversed(sentence), 3))

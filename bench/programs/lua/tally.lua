local m = {}
local n = 0
local x = 12345
for i = 1, 3000000 do
    x = (x * 1103515245 + 12345) % 2147483648
    local k = x % 40000 * 977
    if m[k] == nil then n = n + 1 end
    m[k] = (m[k] or 0) + 1
end
print(n)

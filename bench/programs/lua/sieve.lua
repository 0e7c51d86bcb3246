local function primesBelow(n)
    local composite = {}
    for i = 0, n - 1 do composite[i] = false end
    local count = 0
    for i = 2, n - 1 do
        if not composite[i] then
            count = count + 1
            for j = i * i, n - 1, i do composite[j] = true end
        end
    end
    return count
end
local total = 0
for k = 0, 7 do total = total + primesBelow(400000 + k) end
print(total)

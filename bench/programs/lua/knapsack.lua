local function best(weights, values, count, capacity)
    local t = {}
    for c = 0, capacity do t[c] = 0 end
    for i = 0, count - 1 do
        for c = capacity, weights[i], -1 do
            local with = t[c - weights[i]] + values[i]
            if with > t[c] then t[c] = with end
        end
    end
    return t[capacity]
end
local weights, values = {}, {}
local state = 11
for i = 0, 199 do
    state = (state * 1103515245 + 12345) % 2147483648
    weights[i] = 10 + state // 65536 % 90
    state = (state * 1103515245 + 12345) % 2147483648
    values[i] = 1 + state // 65536 % 500
end
local sum = 0
for k = 0, 7 do sum = sum + best(weights, values, 200, 5000 + k) end
print(sum)

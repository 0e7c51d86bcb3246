local function order(p, count)
    local n = count - 1
    local cost = {}
    for i = 0, n - 1 do
        local row = {}
        for j = 0, n - 1 do row[j] = 0 end
        cost[i] = row
    end
    for len = 2, n do
        for i = 0, n - len do
            local j = i + len - 1
            cost[i][j] = 1000000000000
            for k = i, j - 1 do
                local c = cost[i][k] + cost[k + 1][j] + p[i] * p[k + 1] * p[j + 1]
                if c < cost[i][j] then cost[i][j] = c end
            end
        end
    end
    return cost[0][n - 1]
end
local seedling = 3
local total = 0
for r = 0, 3 do
    local sizes = {}
    for i = 0, 160 do
        seedling = (seedling * 1103515245 + 12345) % 2147483648
        sizes[i] = 5 + seedling // 65536 % 60
    end
    total = total + order(sizes, 161)
end
print(total)

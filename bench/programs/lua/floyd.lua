local n = 180
local d = {}
local state = 17
for i = 0, n - 1 do
    d[i] = {}
    for j = 0, n - 1 do
        state = (state * 1103515245 + 12345) % 2147483648
        d[i][j] = i == j and 0 or 1 + state // 65536 % 1000
    end
end
for k = 0, n - 1 do
    for i = 0, n - 1 do
        for j = 0, n - 1 do
            if d[i][k] + d[k][j] < d[i][j] then
                d[i][j] = d[i][k] + d[k][j]
            end
        end
    end
end
local total = 0
for i = 0, n - 1 do
    for j = 0, n - 1 do total = total + d[i][j] end
end
print(total)

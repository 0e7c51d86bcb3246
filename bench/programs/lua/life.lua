local rows, columns = 96, 96
local function grid()
    local g = {}
    for y = 0, rows - 1 do
        local r = {}
        for x = 0, columns - 1 do r[x] = 0 end
        g[y] = r
    end
    return g
end
local function step(world)
    local next = grid()
    for y = 0, rows - 1 do
        for x = 0, columns - 1 do
            local neighbours = 0
            for dy = -1, 1 do
                for dx = -1, 1 do
                    if dx ~= 0 or dy ~= 0 then
                        neighbours = neighbours + world[(y + dy + rows) % rows][(x + dx + columns) % columns]
                    end
                end
            end
            if neighbours == 3 or (neighbours == 2 and world[y][x] == 1) then next[y][x] = 1 end
        end
    end
    return next
end
local world = grid()
local state = 9
for y = 0, rows - 1 do
    for x = 0, columns - 1 do
        state = (state * 1103515245 + 12345) % 2147483648
        world[y][x] = state // 65536 % 2
    end
end
for k = 0, 29 do world = step(world) end
local alive = 0
for y = 0, rows - 1 do for x = 0, columns - 1 do alive = alive + world[y][x] end end
print(alive)

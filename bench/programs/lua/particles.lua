local function bounce(b, dt)
    local c = {x = b.x, y = b.y, vx = b.vx, vy = b.vy, hits = b.hits}
    c.x = c.x + c.vx * dt
    c.y = c.y + c.vy * dt
    if c.x < 0 or c.x > 100 then
        c.vx = -c.vx
        c.hits = c.hits + 1
    end
    if c.y < 0 or c.y > 100 then
        c.vy = -c.vy
        c.hits = c.hits + 1
    end
    return c
end
local bodies = {}
local state = 4
local function next()
    state = (state * 1103515245 + 12345) % 2147483648
    return state / 2147483648.0
end
for i = 0, 199 do
    bodies[i] = {x = 100 * next(), y = 100 * next(), vx = next() - 0.5, vy = next() - 0.5, hits = 0}
end
for k = 0, 1999 do
    for i = 0, 199 do bodies[i] = bounce(bodies[i], 0.7) end
end
local hits, sx = 0, 0.0
for i = 0, 199 do
    local b = bodies[i]
    hits = hits + b.hits
    sx = sx + (b.x + b.y)
end
print(string.format("%d %.6f", hits, sx))

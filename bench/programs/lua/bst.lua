local function build(n)
    local nodes, size = {}, 0
    local state = 77
    for i = 0, n - 1 do
        state = (state * 1103515245 + 12345) % 2147483648
        local key = state // 64 % 1000000
        if size == 0 then
            nodes[size] = {key = key, left = -1, right = -1, count = 1}
            size = size + 1
        else
            local at = 0
            local going = true
            while going do
                if key == nodes[at].key then
                    nodes[at].count = nodes[at].count + 1
                    going = false
                elseif key < nodes[at].key then
                    if nodes[at].left < 0 then
                        nodes[at].left = size
                        nodes[size] = {key = key, left = -1, right = -1, count = 1}
                        size = size + 1
                        going = false
                    else
                        at = nodes[at].left
                    end
                else
                    if nodes[at].right < 0 then
                        nodes[at].right = size
                        nodes[size] = {key = key, left = -1, right = -1, count = 1}
                        size = size + 1
                        going = false
                    else
                        at = nodes[at].right
                    end
                end
            end
        end
    end
    return nodes, size
end
local max = math.max
local function depth(nodes, at)
    if at < 0 then return 0 end
    return 1 + max(depth(nodes, nodes[at].left), depth(nodes, nodes[at].right))
end
local tree, size = build(50000)
local doubles = 0
for i = 0, size - 1 do if tree[i].count > 1 then doubles = doubles + 1 end end
print(size, depth(tree, 0), doubles)

local function run(code, rounds)
    local stack, memory = {}, {}
    for i = 0, 63 do stack[i] = 0 end
    for i = 0, 15 do memory[i] = 0 end
    local top, pc = 0, 0
    memory[0] = rounds
    while true do
        local step = code[pc]
        pc = pc + 1
        local op = step.op
        if op == 0 then stack[top] = step.arg top = top + 1
        elseif op == 1 then stack[top] = memory[step.arg] top = top + 1
        elseif op == 2 then top = top - 1 memory[step.arg] = stack[top]
        elseif op == 3 then top = top - 1 stack[top - 1] = stack[top - 1] + stack[top]
        elseif op == 4 then top = top - 1 stack[top - 1] = stack[top - 1] - stack[top]
        elseif op == 5 then top = top - 1 stack[top - 1] = stack[top - 1] * stack[top] % 65537
        elseif op == 6 then top = top - 1 if stack[top] ~= 0 then pc = step.arg end
        else return memory[1] end
    end
end
local function S(op, arg) return {op = op, arg = arg} end
local code = {[0] = S(0, 1), S(2, 1), S(1, 1), S(0, 75), S(5, 0), S(1, 0), S(3, 0), S(2, 1), S(1, 0), S(0, 1), S(4, 0),
    S(2, 0), S(1, 0), S(6, 2), S(7, 0)}
print(run(code, 400000))

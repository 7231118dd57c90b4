package org.pendant.script.vm;

import org.pendant.script.value.NumberList;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Processor.Stop;

/**
 * Instruction loop: interprets instructions. Numbers are handled here, unboxed; everything else is
 * left to {@link SlowPath}.
 *
 * <p>The loop is one method on purpose: it stays below the size up to which the JVM compiles it.
 */
final class InstructionLoop {
  private static final int INT = Registers.INT;
  private static final int FLOAT = Registers.FLOAT;
  private static final int BOOL = Registers.BOOL;
  private static final int OBJECT = Registers.OBJECT;
  private static final int UNASSIGNED = Registers.UNASSIGNED;

  private final ProgramRun run;
  private final Registers registers;
  private final GeneralOperations general;
  private final SlowPath slow;
  private final HotFunctions hot;

  InstructionLoop(ProgramRun run, GeneralOperations general, SlowPath slow, HotFunctions hot) {
    this.run = run;
    this.registers = run.registers();
    this.general = general;
    this.slow = slow;
    this.hot = hot;
  }

  /**
   * Runs the innermost frame of {@code thread}, and those it calls, until it stops or a translated
   * function is the innermost.
   */
  Stop run(ScriptThread thread) throws ScriptError {
    double[] num = registers.numbers();
    byte[] tag = registers.tags();
    Value[] ref = registers.objects();
    byte[] marks = run.marks();
    ScriptFunction[] functions = run.functions();
    ScriptFunction function = thread.functions[thread.depth - 1];
    long[] code = function.code();
    int base = thread.bases[thread.depth - 1];
    int pc = thread.pcs[thread.depth - 1];
    // a thread that continues from a trap executes what the trap stands in place of
    long w = thread.before() ? function.instructions()[pc++] : code[pc++];
    thread.trapped = false;
    thread.interrupted = false;
    while (true) {
      int a = Instruction.a(w);
      switch (Instruction.operation(w)) {
        case Op.MOVE -> {
          int s = Instruction.slot(Instruction.b(w), base);
          int d = Instruction.slot(a, base);
          int t = tag[s];
          if (t == UNASSIGNED) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          tag[d] = (byte) t;
          num[d] = num[s];
          if (t == OBJECT) {
            ref[d] = ref[s];
          }
        }
        case Op.COPY -> {
          int s = Instruction.slot(Instruction.b(w), base);
          int d = Instruction.slot(a, base);
          int t = tag[s];
          if (t < OBJECT) {
            tag[d] = (byte) t;
            num[d] = num[s];
          } else if (slow.run(thread, base, pc) != Stop.GOES_ON) {
            return Stop.EXHAUSTED;
          }
        }
        case Op.ASSIGN, Op.ASSIGN_COPY -> {
          int s = Instruction.slot(Instruction.b(w), base);
          int d = Instruction.slot(a, base);
          int t = tag[s];
          if ((t | tag[d]) <= FLOAT || (t <= BOOL && tag[d] == UNASSIGNED)) {
            tag[d] = (byte) t;
            num[d] = num[s];
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.UNSET -> tag[Instruction.slot(a, base)] = (byte) UNASSIGNED;
        case Op.ADD -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          int t = tag[x] | tag[y];
          double r = num[x] + num[y];
          if ((t | (tag[d] & Processor.NOT_FOR_NUMBER)) <= FLOAT && (t != INT || r == (int) r)) {
            num[d] = r;
            tag[d] = (byte) t;
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.SUBTRACT -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          int t = tag[x] | tag[y];
          double r = num[x] - num[y];
          if ((t | (tag[d] & Processor.NOT_FOR_NUMBER)) <= FLOAT && (t != INT || r == (int) r)) {
            num[d] = r;
            tag[d] = (byte) t;
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.MULTIPLY -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          int t = tag[x] | tag[y];
          double r = num[x] * num[y];
          if ((t | (tag[d] & Processor.NOT_FOR_NUMBER)) <= FLOAT && (t != INT || r == (int) r)) {
            // an int has no negative zero
            num[d] = t == INT ? r + 0.0 : r;
            tag[d] = (byte) t;
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.DIVIDE -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          if ((tag[x] | tag[y] | (tag[d] & Processor.NOT_FOR_NUMBER)) <= FLOAT && num[y] != 0) {
            num[d] = num[x] / num[y];
            tag[d] = (byte) FLOAT;
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.MODULO -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          // the JVM's floating point remainder is slow, and ints are the usual case
          if ((tag[x] | tag[y] | (tag[d] & Processor.NOT_FOR_NUMBER)) == INT && num[y] != 0) {
            num[d] = (int) num[x] % (int) num[y];
            tag[d] = (byte) INT;
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.EQUAL -> {
          int d = Instruction.slot(a, base);
          int equal = equal(thread, base, pc, Instruction.b(w), Instruction.c(w));
          if (equal == SlowPath.STOPPED) {
            return Stop.EXHAUSTED;
          }
          num[d] = equal;
          tag[d] = (byte) BOOL;
        }
        case Op.NOT_EQUAL -> {
          int d = Instruction.slot(a, base);
          int equal = equal(thread, base, pc, Instruction.b(w), Instruction.c(w));
          if (equal == SlowPath.STOPPED) {
            return Stop.EXHAUSTED;
          }
          num[d] = 1 - equal;
          tag[d] = (byte) BOOL;
        }
        case Op.LESS -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          num[d] = num[x] < num[y] ? 1 : 0;
          tag[d] = (byte) BOOL;
        }
        case Op.LESS_OR_EQUAL -> {
          int x = Instruction.slot(Instruction.b(w), base);
          int y = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          num[d] = num[x] <= num[y] ? 1 : 0;
          tag[d] = (byte) BOOL;
        }
        case Op.NOT -> {
          int s = Instruction.slot(Instruction.b(w), base);
          int d = Instruction.slot(a, base);
          if (tag[s] > BOOL) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          num[d] = num[s] == 0 ? 1 : 0;
          tag[d] = (byte) BOOL;
        }
        case Op.JUMP_IF_GIVEN -> {
          if (tag[Instruction.slot(a, base)] != UNASSIGNED) {
            pc += Instruction.distance(w);
          }
        }
        case Op.JUMP -> pc += Instruction.distance(w);
        case Op.LOOP -> {
          pc += Instruction.distance(w);
          thread.budget -= Cost.turn(-Instruction.distance(w) - a);
          if (thread.budget < 0) {
            return Processor.stop(thread, pc, Stop.EXHAUSTED);
          }
          Stop turned = hot.turn(function);
          if (turned != Stop.GOES_ON) {
            return Processor.stop(thread, pc, turned);
          }
        }
        case Op.JUMP_IF_FALSE -> {
          int s = Instruction.slot(a, base);
          if (tag[s] > BOOL) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (num[s] == 0) {
            pc += Instruction.distance(w);
          }
        }
        case Op.JUMP_IF_TRUE -> {
          int s = Instruction.slot(a, base);
          if (tag[s] > BOOL) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (num[s] != 0) {
            pc += Instruction.distance(w);
          }
        }
        case Op.JUMP_IF_LESS -> {
          int x = Instruction.slot(a, base);
          int y = Instruction.slot(Instruction.b(w), base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (num[x] < num[y]) {
            pc += Instruction.c(w);
          }
        }
        case Op.JUMP_IF_LESS_OR_EQUAL -> {
          int x = Instruction.slot(a, base);
          int y = Instruction.slot(Instruction.b(w), base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (num[x] <= num[y]) {
            pc += Instruction.c(w);
          }
        }
        case Op.JUMP_IF_NOT_LESS -> {
          int x = Instruction.slot(a, base);
          int y = Instruction.slot(Instruction.b(w), base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (!(num[x] < num[y])) {
            pc += Instruction.c(w);
          }
        }
        case Op.JUMP_IF_NOT_LESS_OR_EQUAL -> {
          int x = Instruction.slot(a, base);
          int y = Instruction.slot(Instruction.b(w), base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (!(num[x] <= num[y])) {
            pc += Instruction.c(w);
          }
        }
        case Op.JUMP_IF_EQUAL, Op.JUMP_IF_NOT_EQUAL -> {
          int equal = equal(thread, base, pc, a, Instruction.b(w));
          if (equal == SlowPath.STOPPED) {
            return Stop.EXHAUSTED;
          }
          if (equal != 0 == (Instruction.operation(w) == Op.JUMP_IF_EQUAL)) {
            pc += Instruction.c(w);
          }
        }
        case Op.LOOP_IF_LESS -> {
          int x = Instruction.slot(a, base);
          int y = Instruction.slot(Instruction.b(w), base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (num[x] < num[y]) {
            pc += Instruction.c(w);
            thread.budget -= Cost.turn(-Instruction.c(w));
            if (thread.budget < 0) {
              return Processor.stop(thread, pc, Stop.EXHAUSTED);
            }
            Stop turned = hot.turn(function);
            if (turned != Stop.GOES_ON) {
              return Processor.stop(thread, pc, turned);
            }
          }
        }
        case Op.LOOP_IF_LESS_OR_EQUAL -> {
          int x = Instruction.slot(a, base);
          int y = Instruction.slot(Instruction.b(w), base);
          if ((tag[x] | tag[y]) > FLOAT) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          if (num[x] <= num[y]) {
            pc += Instruction.c(w);
            thread.budget -= Cost.turn(-Instruction.c(w));
            if (thread.budget < 0) {
              return Processor.stop(thread, pc, Stop.EXHAUSTED);
            }
            Stop turned = hot.turn(function);
            if (turned != Stop.GOES_ON) {
              return Processor.stop(thread, pc, turned);
            }
          }
        }
        case Op.CALL -> {
          ScriptFunction callee = functions[Instruction.b(w)];
          int offset = Instruction.index(Instruction.c(w));
          int depth = thread.depth;
          thread.pcs[depth - 1] = pc;
          if (thread.budget < 0) {
            return Processor.stop(thread, pc - 1, Stop.EXHAUSTED);
          }
          thread.budget -= callee.callNs();
          if (depth >= ScriptThread.MAX_DEPTH
              || base + offset + callee.slotCount() > thread.segmentEnd) {
            general.makeRoom(thread, callee, base + offset);
            num = registers.numbers();
            tag = registers.tags();
            ref = registers.objects();
            base = thread.bases[depth - 1];
          }
          base += offset;
          for (int i = base + callee.parameterCount(), end = base + callee.variableCount();
              i < end;
              i++) {
            tag[i] = (byte) UNASSIGNED;
          }
          thread.push(callee, base, Instruction.index(a));
          if (hot.counts(callee)) {
            return Stop.CALLED;
          }
          function = callee;
          code = callee.code();
          pc = 0;
        }
        case Op.RETURN, Op.RETURN_NONE -> {
          int s = Instruction.slot(a, base);
          int t = Instruction.operation(w) == Op.RETURN ? tag[s] : Registers.NONE;
          if (t == UNASSIGNED) {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
          int depth = --thread.depth;
          if (depth == 0) {
            return Stop.ENDED;
          }
          function = thread.functions[depth - 1];
          base = thread.bases[depth - 1];
          int d = base + thread.results[depth];
          tag[d] = (byte) t;
          num[d] = num[s];
          if (t == OBJECT) {
            ref[d] = ref[s];
          }
          if (hot.translated(function)) {
            return Stop.RETURNED;
          }
          code = function.code();
          pc = thread.pcs[depth - 1];
        }
        case Op.GET_INDEX -> {
          int l = Instruction.slot(Instruction.b(w), base);
          int i = Instruction.slot(Instruction.c(w), base);
          int d = Instruction.slot(a, base);
          int index = (int) num[i];
          if (tag[l] == OBJECT
              && tag[i] == INT
              && ref[l] instanceof NumberList list
              && index >= 0
              && index < list.length()
              && (list.tag() | (tag[d] & Processor.NOT_FOR_NUMBER)) <= FLOAT) {
            num[d] = list.numberAt(index);
            tag[d] = (byte) list.tag();
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.SET_INDEX -> {
          int l = Instruction.slot(a, base);
          int i = Instruction.slot(Instruction.b(w), base);
          int s = Instruction.slot(Instruction.c(w), base);
          int index = (int) num[i];
          if (tag[l] == OBJECT
              && tag[i] == INT
              && ref[l] instanceof NumberList list
              && index >= 0
              && index < list.length()
              && !list.shared()
              && (list.tag() == tag[s] || (list.tag() == FLOAT && tag[s] == INT))) {
            list.setNumberAt(index, num[s]);
          } else {
            if (slow.run(thread, base, pc) != Stop.GOES_ON) {
              return Stop.EXHAUSTED;
            }
          }
        }
        case Op.STRETCH -> {
          thread.budget -= Cost.STRETCH_NS;
          if (thread.budget < 0) {
            return Processor.stop(thread, pc, Stop.EXHAUSTED);
          }
        }
        case Op.MARK -> marks[Instruction.distance(w)] = 1;
        case Op.TRAP -> {
          thread.trapped = true;
          return Processor.stop(thread, pc - 1, Stop.TRAPPED);
        }
        default -> {
          Stop stop = slow.run(thread, base, pc);
          if (stop != Stop.GOES_ON) {
            return stop;
          }
          // a new thread's segment may have moved the arrays
          num = registers.numbers();
          tag = registers.tags();
          ref = registers.objects();
        }
      }
      w = code[pc++];
    }
  }

  /** Whether operands x and y of the instruction before {@code pc} are equal: 0, 1, or a stop. */
  private int equal(ScriptThread thread, int base, int pc, int x, int y) throws ScriptError {
    byte[] tag = registers.tags();
    int i = Instruction.slot(x, base);
    int j = Instruction.slot(y, base);
    if ((tag[i] | tag[j]) <= FLOAT || (tag[i] == BOOL && tag[j] == BOOL)) {
      return registers.numbers()[i] == registers.numbers()[j] ? 1 : 0;
    }
    return slow.equal(thread, base, pc);
  }
}

package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Outcome;
import org.pendant.controller.call.ProgramControl;
import org.pendant.controller.motion.Move;
import org.pendant.controller.value.ListValue;
import org.pendant.controller.value.MatrixValue;
import org.pendant.controller.value.ObjectList;
import org.pendant.controller.value.Registers;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.StructValue;
import org.pendant.controller.value.Value;

/**
 * Runs a copy of a thread ahead, to learn which moves come after the one that the thread waits for.
 *
 * <p>The copy computes with the values of now. Functions that answer from their arguments or tell
 * the state of the controller do what they always do; functions that only tell something to the
 * outside are passed over; at anything else the copy ends and nothing is known. What it finds is a
 * guess that shapes how fast a blend is approached; which move really comes is decided by the
 * thread itself.
 */
final class Foresight {
  /** Calls and turns of loops after which the copy gives up. */
  private static final int BUDGET = 500;

  /** Moves that are foreseen at most. */
  private static final int MOST_MOVES = 24;

  /** Registers of a program that is too large to copy for each blend. */
  private static final int MOST_REGISTERS = 20_000;

  /** Elements of lists and the like of a program that has too much data to copy for each blend. */
  private static final int MOST_ELEMENTS = 20_000;

  private static final Set<String> COMPUTING = Set.of("urmath", "core");

  /** They answer otherwise each time, or what is not yet so when the thread asks itself. */
  private static final Set<String> NEVER = Set.of("random", "get_steptime");

  /** The beginnings of such names: where the arm is, and what it feels. */
  private static final List<String> OF_THE_ARM =
      List.of("get_actual_", "get_target_", "get_tcp_force", "get_joint_torques", "is_steady");

  /** Of these, what is right for the first move: the goal of the one that is under way. */
  private static final String WAYPOINT = "get_target_waypoint";

  /** They say something to the outside, which does not change what the thread does next. */
  private static final List<String> TELLING =
      List.of(
          "textmsg",
          "write_output_",
          "set_standard_digital_out",
          "set_configurable_digital_out",
          "set_tool_digital_out",
          "set_digital_out",
          "set_standard_analog_out",
          "set_flag",
          "write_port_");

  private static final List<String> ASKING = List.of("get_", "is_", "read_");

  private final ControlBox box;
  private ProgramRun known;
  private int links;
  private Program.Tables tables;

  Foresight(ControlBox box) {
    this.box = box;
  }

  /** What built-ins may do to a thread that is run ahead: say which move comes. */
  private static final class Ahead implements ProgramControl {
    private final long frame;
    private final List<Move> next = new ArrayList<>();

    Ahead(long frame) {
      this.frame = frame;
    }

    @Override
    public long frame() {
      return frame;
    }

    @Override
    public boolean foresees(Move move) throws ScriptError {
      next.add(move);
      if (move.blendRadiusM() == 0 || next.size() == MOST_MOVES) {
        throw ended();
      }
      return true;
    }

    @Override
    public void pause() {}

    @Override
    public void halt() {}

    @Override
    public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd)
        throws ScriptError {
      throw ended();
    }

    @Override
    public void endInterpreter() {}

    @Override
    public void clearInterpreter() throws ScriptError {
      throw ended();
    }
  }

  private static ScriptError ended() {
    return new ScriptError("not-foreseen", "what follows cannot be foreseen");
  }

  /** The moves that {@code thread} will ask for once its wait is over, up to one that stops. */
  List<Move> after(ProgramRun run, ScriptThread thread) {
    Ahead ahead = new Ahead(run.frame());
    try {
      if (run.registers().size() > MOST_REGISTERS || tooMuchData(run.registers())) {
        return List.of();
      }
      ProgramRun side = run.onTheSide(tables(run), box, ahead);
      ScriptThread worker = copy(thread, side.registers());
      side.processor().execute(worker);
    } catch (ScriptError e) {
      // as far as it went; if the thread itself comes to fail there it will say so
    }
    return ahead.next;
  }

  private static boolean tooMuchData(Registers registers) throws ScriptError {
    int left = MOST_ELEMENTS;
    for (int slot = 0; slot < registers.size() && left > 0; slot++) {
      if (registers.tags()[slot] == Registers.OBJECT) {
        left = less(left, registers.objects()[slot]);
      }
    }
    return left <= 0;
  }

  /** What is left of a number of elements after those of {@code value}; below 0 ends early. */
  private static int less(int left, Value value) throws ScriptError {
    int rest = left - 1;
    if (value instanceof MatrixValue matrix) {
      rest -= matrix.rows() * matrix.columns();
    } else if (value instanceof ListValue list) {
      rest -= list.length();
      boolean nested = list instanceof ObjectList;
      for (int i = 0; nested && i < list.length() && rest > 0; i++) {
        rest = less(rest, list.get(i));
      }
    } else if (value instanceof StructValue struct) {
      for (int i = 0; i < struct.length() && rest > 0; i++) {
        rest = less(rest, struct.memberAt(i));
      }
    }
    return rest;
  }

  private static ScriptThread copy(ScriptThread thread, Registers registers) {
    ScriptThread copy = new ScriptThread(thread.id(), thread.parentId());
    for (int i = 0; i < thread.depth; i++) {
      copy.push(thread.functions[i].original(), thread.bases[i], thread.results[i]);
      copy.pcs[i] = thread.pcs[i];
    }
    copy.segmentStart = thread.segmentStart;
    copy.segmentEnd = thread.segmentEnd;
    copy.budget = BUDGET;
    registers.tags()[thread.base() + thread.waitResult] = Registers.NONE;
    for (int slot = 0; slot < registers.size(); slot++) {
      if (registers.tags()[slot] == Registers.OBJECT) {
        registers.objects()[slot] = registers.objects()[slot].copy();
      }
    }
    return copy;
  }

  private Program.Tables tables(ProgramRun run) {
    if (known != run || links != run.links()) {
      known = run;
      links = run.links();
      tables = foreseeing(run.tables());
    }
    return tables;
  }

  private static Program.Tables foreseeing(Program.Tables tables) {
    List<Builtin> builtins = new ArrayList<>();
    for (Builtin builtin : tables.builtins()) {
      builtins.add(foreseeing(builtin));
    }
    return new Program.Tables(
        tables.functions(),
        tables.staticNames(),
        tables.staticValues(),
        builtins,
        tables.names(),
        tables.nameLists());
  }

  private static Builtin foreseeing(Builtin builtin) {
    String name = builtin.name();
    if (starts(name, TELLING)) {
      return new Builtin(builtin.signature(), builtin.defaults(), call -> call.answer());
    }
    if (name.equals(WAYPOINT)) {
      return beforeTheFirstMove(builtin);
    }
    boolean computes = COMPUTING.contains(builtin.signature().module()) || starts(name, ASKING);
    boolean moves = name.startsWith("move") || name.startsWith("optimove");
    boolean another = NEVER.contains(name) || starts(name, OF_THE_ARM);
    if (moves || (computes && !builtin.signature().physicalTime() && !another)) {
      return builtin;
    }
    return new Builtin(
        builtin.signature(),
        builtin.defaults(),
        call -> {
          throw ended();
        });
  }

  private static Builtin beforeTheFirstMove(Builtin builtin) {
    return new Builtin(
        builtin.signature(),
        builtin.defaults(),
        call -> {
          if (call.program() instanceof Ahead ahead && ahead.next.isEmpty()) {
            return builtin.code().run(call);
          }
          throw ended();
        });
  }

  private static boolean starts(String name, List<String> beginnings) {
    return beginnings.stream().anyMatch(name::startsWith);
  }
}

package org.pendant.controller.machine;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.call.Builtin;
import org.pendant.controller.call.Outcome;
import org.pendant.controller.call.ProgramControl;
import org.pendant.controller.motion.Move;
import org.pendant.controller.value.Registers;
import org.pendant.controller.value.ScriptError;

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
  private static final int BUDGET = 5000;

  /** Moves that are foreseen at most. */
  private static final int MOST_MOVES = 24;

  /** Registers of a program that is too large to copy for each blend. */
  private static final int MOST_REGISTERS = 20_000;

  private static final Set<String> COMPUTING = Set.of("urmath", "core");

  /** They answer otherwise each time, or say how the path after them is to be taken. */
  private static final Set<String> NEVER = Set.of("random");

  /** They say something to the outside, which does not change what the thread does next. */
  private static final List<String> TELLING =
      List.of("textmsg", "write_output_", "set_standard_digital_out", "set_configurable_digital_out",
          "set_tool_digital_out", "set_digital_out", "set_standard_analog_out", "set_flag",
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
    if (run.registers().size() > MOST_REGISTERS) {
      return List.of();
    }
    Ahead ahead = new Ahead(run.frame());
    ProgramRun side = run.onTheSide(tables(run), box, ahead);
    ScriptThread worker = copy(thread, side.registers());
    try {
      side.processor().execute(worker);
    } catch (ScriptError e) {
      // as far as it went; if the thread itself comes to fail there it will say so
    }
    return ahead.next;
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
    boolean computes = COMPUTING.contains(builtin.signature().module()) || starts(name, ASKING);
    boolean moves = name.startsWith("move") || name.startsWith("optimove");
    if (moves || (computes && !builtin.signature().physicalTime() && !NEVER.contains(name))) {
      return builtin;
    }
    return new Builtin(
        builtin.signature(),
        builtin.defaults(),
        call -> {
          throw ended();
        });
  }

  private static boolean starts(String name, List<String> beginnings) {
    return beginnings.stream().anyMatch(name::startsWith);
  }
}

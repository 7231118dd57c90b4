package org.pendant.script.variables;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.script.debug.Variables;
import org.pendant.script.value.Registers;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.VariableSlots;

/**
 * Variable sampler: takes {@link VariableSamples} every 20 frames, in the first and last frame of a
 * program, when a debugger has stopped it, and when the main thread has come to another line, if
 * there are not many variables: people who go back by statements find what they were then. A
 * variable keeps at most {@link #MAX_PARTS} elements and members, all together at most {@link
 * #MAX_IN_ALL}; programs that have many are sampled less often, so that the mean cost of a frame
 * stays the same. Frame loop only.
 */
public final class VariableSampler {
  /** Frames from one sample to the next. */
  public static final int FRAMES = 20;

  /** Elements and members that a variable keeps. */
  public static final int MAX_PARTS = 1000;

  /** Variables, elements and members of a sample. */
  public static final int MAX_IN_ALL = 10_000;

  /** A sample of so many parts comes after {@link #FRAMES}; one of twice as many after twice. */
  private static final int PARTS_IN_TIME = 500;

  /** A program whose samples have more parts is not sampled for each line. */
  private static final int PARTS_FOR_LINES = 200;

  private final Machine machine;
  private Optional<VariableSlots> sampled = Optional.empty();
  private VariableSamples samples = VariableSamples.NONE;
  private boolean ended;
  private int wait;
  private int left;
  private int line;
  private long stop;

  /** Samples what {@code machine} runs. */
  public VariableSampler(Machine machine) {
    this.machine = machine;
  }

  /**
   * The newest sample; takes one if it is time, once a frame.
   *
   * @param stopNumber of the debugger's stop that holds the program; 0 while none does
   */
  public VariableSamples read(long stopNumber) {
    Optional<VariableSlots> slots = machine.variableSlots();
    if (slots.isEmpty()) {
      return samples;
    }
    boolean fresh = sampled.isEmpty() || sampled.get() != slots.get();
    boolean stopped = machine.state() == ProgramState.STOPPED;
    boolean otherStop = stopNumber != 0 && stopNumber != stop;
    int reached = machine.line();
    boolean otherLine = reached != line && MAX_IN_ALL - left <= PARTS_FOR_LINES;
    stop = stopNumber;
    line = reached;
    boolean moved = otherStop || otherLine;
    if (fresh || stopped != ended || (!stopped && (--wait <= 0 || moved))) {
      if (fresh) {
        samples = new VariableSamples(samples.run() + 1, List.of(), "", List.of(), 0);
      }
      sampled = slots;
      ended = stopped;
      take(slots.get());
    }
    return samples;
  }

  private void take(VariableSlots slots) {
    left = MAX_IN_ALL;
    List<VariableSample> globals = new ArrayList<>(samples.globals().size());
    List<String> names = slots.globals();
    for (int i = 0; i < names.size() && left > 0; i++) {
      globals.add(sample(names.get(i), slots, slots.global(i), samples.globals(), i));
    }
    int omitted = names.size() - globals.size();
    List<VariableSample> locals = List.of();
    int first = slots.firstLocal();
    if (first != VariableSlots.NONE) {
      locals = locals(slots, first);
      omitted += slots.locals().size() - locals.size();
    }
    wait = FRAMES * Math.ceilDiv(Math.max(1, MAX_IN_ALL - left), PARTS_IN_TIME);
    if (!same(globals, samples.globals()) || !same(locals, samples.locals())) {
      samples = new VariableSamples(samples.run(), globals, slots.mainFunction(), locals, omitted);
    }
  }

  private List<VariableSample> locals(VariableSlots slots, int first) {
    List<VariableSample> locals = new ArrayList<>();
    List<String> names = slots.locals();
    for (int i = 0; i < names.size() && left > 0; i++) {
      locals.add(sample(names.get(i), slots, first + i, samples.locals(), i));
    }
    return locals;
  }

  /** Whether these are the same objects. */
  private static boolean same(List<VariableSample> some, List<VariableSample> others) {
    if (some.size() != others.size()) {
      return false;
    }
    for (int i = 0; i < some.size(); i++) {
      if (some.get(i) != others.get(i)) {
        return false;
      }
    }
    return true;
  }

  private VariableSample sample(
      String name, VariableSlots slots, int slot, List<VariableSample> before, int place) {
    Optional<VariableSample> last =
        place < before.size() ? Optional.of(before.get(place)) : Optional.empty();
    Registers registers = slots.registers();
    left--;
    if (!registers.assigned(slot)) {
      return last.filter(each -> each.shared().isEmpty())
          .orElseGet(() -> VariableSample.unassigned(name));
    }
    Value value = registers.value(slot);
    int length = Variables.childCount(value);
    int parts = Math.min(MAX_PARTS, left);
    Optional<Value> known = last.flatMap(VariableSample::shared);
    boolean whole =
        length <= parts
            && !(value instanceof StringValue string && string.length() > BoundedCopy.MAX_BYTES);
    if (whole && known.isPresent() && BoundedCopy.same(value, known.get())) {
      left -= length;
      return last.orElseThrow();
    }
    BoundedCopy copier = new BoundedCopy(parts);
    Value copy = copier.of(value);
    left -= parts - copier.left();
    VariableSample made = new VariableSample(name, name, Optional.of(copy), length);
    return known.isPresent() && last.orElseThrow().fits(name, Optional.of(copy), length)
        ? last.orElseThrow()
        : made;
  }
}

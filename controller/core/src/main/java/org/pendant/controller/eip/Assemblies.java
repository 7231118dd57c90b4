package org.pendant.controller.eip;

import static org.pendant.controller.eip.AssemblyDataTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Refusal.Code;
import org.pendant.script.value.ScriptError;

/**
 * Assemblies that are configured, and the handles by which the running program reaches them.
 * Assemblies and their bytes outlive programs, handles do not. Owned by the frame loop; times are
 * those of the controller, s.
 */
public final class Assemblies {
  /** Most pairs that can be configured. */
  public static final int MAX_PAIRS = 16;

  /** Most handles that a program may open. */
  public static final int MAX_HANDLES = 128;

  private final List<AssemblyPair> pairs = new ArrayList<>();
  private final Map<Integer, AssemblyData> toPlc = new LinkedHashMap<>();
  private final Map<Integer, AssemblyData> fromPlc = new LinkedHashMap<>();
  private final List<AssemblyHandle> handles = new ArrayList<>();

  /**
   * What a PLC of the cell has written to the built-in assembly, unless another scanner did since.
   */
  private Optional<AssemblyData> builtIn = Optional.empty();

  private AssemblyImage image = AssemblyImage.EMPTY;
  private boolean changed;

  /**
   * Makes the assemblies of a pair, all zero; one that is there already, with the same sizes, stays
   * as it is.
   *
   * @return why not; empty when the pair is there
   */
  public Optional<Refusal> configure(AssemblyPair pair) {
    if (pairs.contains(pair)) {
      return Optional.empty();
    }
    for (int id : List.of(pair.toPlcId(), pair.fromPlcId())) {
      if (toPlc.containsKey(id) || fromPlc.containsKey(id)) {
        return Optional.of(new Refusal(Code.IN_USE, text("exists", id)));
      }
    }
    if (pairs.size() >= MAX_PAIRS) {
      return Optional.of(new Refusal(Code.LIMIT, text("mostPairs", MAX_PAIRS)));
    }
    pairs.add(pair);
    toPlc.put(pair.toPlcId(), AssemblyData.zero(pair.toPlcBytes()));
    fromPlc.put(pair.fromPlcId(), AssemblyData.zero(pair.fromPlcBytes()));
    changed = true;
    return Optional.empty();
  }

  /**
   * The scanner has written an assembly.
   *
   * @return why it has no effect; empty when it has
   */
  public Optional<Refusal> received(int instance, AssemblyData data, double nowS) {
    AssemblyData before = fromPlc.get(instance);
    if (before == null) {
      return Optional.of(new Refusal(Code.UNKNOWN, text("noInstance", instance)));
    }
    if (before.size() != data.size()) {
      return Optional.of(
          new Refusal(Code.INVALID, text("otherSize", instance, before.size(), data.size())));
    }
    if (!before.equals(data)) {
      fromPlc.put(instance, data);
      changed = true;
    }
    for (AssemblyHandle handle : handles) {
      if (handle.reads(instance)) {
        handle.watchdog().ifPresent(watchdog -> watchdog.begin(nowS));
      }
    }
    return Optional.empty();
  }

  /** A PLC of the cell has written the built-in assembly. */
  public void writeBuiltIn(AssemblyData data) {
    if (builtIn.isEmpty() || !builtIn.get().equals(data)) {
      builtIn = Optional.of(data);
      changed = true;
    }
  }

  /** A scanner at the port has written the built-in assembly. */
  public void writtenFromOutside() {
    if (builtIn.isPresent()) {
      builtIn = Optional.empty();
      changed = true;
    }
  }

  /** What the scanner has written. */
  AssemblyData fromPlc(int instance) {
    return fromPlc.get(instance);
  }

  /** What the program has written. */
  AssemblyData toPlc(int instance) {
    return toPlc.get(instance);
  }

  /** The program writes an assembly. */
  void write(int instance, AssemblyData data) {
    if (!data.equals(toPlc.put(instance, data))) {
      changed = true;
    }
  }

  /**
   * Opens a handle.
   *
   * @param reading whether it is for what the scanner writes, or for what the robot does
   * @param bytes how large the program believes the assembly to be
   * @return its number, from 1
   * @throws ScriptError when there is no such assembly, it has another size, or there are too many
   *     handles
   */
  public int open(boolean reading, int instance, int bytes) throws ScriptError {

    AssemblyData data = (reading ? fromPlc : toPlc).get(instance);
    if (data == null) {
      throw new ScriptError(
          "unknown-assembly", text(reading ? "noneFromScanner" : "noneToScanner", instance));
    }
    if (data.size() != bytes) {
      throw new ScriptError("value-out-of-range", text("dataSize", bytes, data.size(), instance));
    }
    if (handles.size() >= MAX_HANDLES) {
      throw new ScriptError("too-many-handles", text("mostHandles", MAX_HANDLES));
    }
    handles.add(new AssemblyHandle(this, reading, instance, bytes));
    return handles.size();
  }

  /**
   * The handle with that number.
   *
   * @throws ScriptError when it is closed, or of an earlier program
   */
  public AssemblyHandle handle(int number) throws ScriptError {
    if (number > handles.size() || handles.get(number - 1).closed()) {
      throw new ScriptError("handle-closed", text("closed"));
    }
    return handles.get(number - 1);
  }

  /**
   * Watchdogs of handles that are late in this frame and were not before.
   *
   * @param running whether the program runs
   */
  public List<AssemblyWatchdog.Violation> step(boolean running, double nowS) {
    if (handles.isEmpty()) {
      return List.of();
    }
    List<AssemblyWatchdog.Violation> violations = new ArrayList<>();
    for (AssemblyHandle handle : handles) {
      handle.watchdog().flatMap(each -> each.step(running, nowS)).ifPresent(violations::add);
    }
    return violations;
  }

  /** Closes all handles. */
  public void programEnded() {
    handles.clear();
  }

  /** The assemblies now; the same object until one changes. */
  public AssemblyImage image() {
    if (changed) {
      changed = false;
      Map<Integer, AssemblyData> written = new LinkedHashMap<>(fromPlc);
      builtIn.ifPresent(data -> written.put(AssemblyPair.BUILT_IN_FROM_PLC, data));
      image = new AssemblyImage(pairs, toPlc, written);
    }
    return image;
  }
}

package org.pendant.controller.eip;

import static org.pendant.controller.eip.AssemblyDataTexts.text;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/**
 * Assembly handle of a program: which labels stand where in the assembly, and reading or writing by
 * them (manual 21.3). What refuses leaves everything as it was.
 */
public final class AssemblyHandle {
  /** Most labels of a handle. */
  public static final int MAX_LABELS = 1024;

  private static final int MAX_LABEL = 255;

  private final Assemblies assemblies;
  private final boolean reading;
  private final int instance;
  private final int bytes;
  private final Map<String, AssemblyField> fields = new LinkedHashMap<>();
  private Optional<AssemblyWatchdog> watchdog = Optional.empty();
  private boolean closed;

  AssemblyHandle(Assemblies assemblies, boolean reading, int instance, int bytes) {
    this.assemblies = assemblies;
    this.reading = reading;
    this.instance = instance;
    this.bytes = bytes;
  }

  boolean closed() {
    return closed;
  }

  boolean reads(int id) {
    return reading && instance == id;
  }

  Optional<AssemblyWatchdog> watchdog() {
    return watchdog;
  }

  /**
   * Gives a label to a part of the assembly.
   *
   * @throws ScriptError when the label is used, or the field does not fit
   */
  public void define(String label, AssemblyField field) throws ScriptError {
    if (label.isBlank() || label.length() > MAX_LABEL) {
      throw new ScriptError("value-out-of-range", text("labelLength", label.length(), MAX_LABEL));
    }
    if (fields.containsKey(label)) {
      throw new ScriptError("label-in-use", text("labelAgain", label));
    }
    if (fields.size() >= MAX_LABELS) {
      throw new ScriptError("too-many-labels", text("mostLabels", MAX_LABELS));
    }
    if (field.endBit() > (long) bytes * Byte.SIZE) {
      throw new ScriptError(
          "value-out-of-range",
          text("beyondEnd", label, (field.endBit() + Byte.SIZE - 1) / Byte.SIZE, bytes, instance));
    }
    for (Map.Entry<String, AssemblyField> other : fields.entrySet()) {
      if (field.collidesWith(other.getValue())) {
        throw new ScriptError("overlap", text("overlap", label, other.getKey()));
      }
    }
    fields.put(label, field);
  }

  /**
   * Reads what the scanner has written at a label.
   *
   * @throws ScriptError when there is no such label, or this handle is for writing
   */
  public Value read(String label) throws ScriptError {
    if (!reading) {
      throw new ScriptError("wrong-handle", text("forWriting"));
    }
    return field(label).read(assemblies.fromPlc(instance).view());
  }

  /**
   * Reads several labels of one moment into a struct of these names.
   *
   * @throws ScriptError as {@link #read(String)}, and when a label is given twice
   */
  public StructValue read(List<String> labels) throws ScriptError {
    Set<String> seen = new HashSet<>();
    Value[] values = new Value[labels.size()];
    for (int i = 0; i < values.length; i++) {
      if (!seen.add(labels.get(i))) {
        throw new ScriptError("label-in-use", text("labelTwice", labels.get(i)));
      }
      values[i] = read(labels.get(i));
    }
    return StructValue.owning(labels, values);
  }

  /**
   * Writes all members of a struct at once, each to the label of its name.
   *
   * @throws ScriptError when there is no such label, a value does not fit, or this handle is for
   *     reading; nothing is written then
   */
  public void write(StructValue values) throws ScriptError {
    requireWriting();
    byte[] copy = assemblies.toPlc(instance).toArray();
    ByteBuffer data = ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < values.length(); i++) {
      String label = values.names().get(i);
      try {
        field(label).write(data, values.memberAt(i));
      } catch (WrongFieldValue e) {
        throw new ScriptError(e.code(), e.of(label));
      }
    }
    assemblies.write(instance, AssemblyData.of(copy));
  }

  /**
   * Makes every byte of the assembly zero.
   *
   * @throws ScriptError when this handle is for reading
   */
  public void clear() throws ScriptError {
    requireWriting();
    assemblies.write(instance, AssemblyData.zero(bytes));
  }

  private void requireWriting() throws ScriptError {
    if (reading) {
      throw new ScriptError("wrong-handle", text("forReading"));
    }
  }

  private AssemblyField field(String label) throws ScriptError {
    AssemblyField field = fields.get(label);
    if (field == null) {
      throw new ScriptError("unknown-label", text("unknownLabel", label));
    }
    return field;
  }

  /**
   * Watches from now on that the scanner writes often enough; takes the place of the watchdog
   * before.
   *
   * @param leastHz how often, Hz, above 0
   * @throws ScriptError when this handle is for writing
   */
  public void setWatchdog(double leastHz, WatchdogAction action, double nowS) throws ScriptError {
    if (!reading) {
      throw new ScriptError("wrong-handle", text("forWriting"));
    }
    watchdog =
        Optional.of(
            new AssemblyWatchdog(new AssemblyWatchdog.Violation(instance, leastHz, action), nowS));
  }

  /**
   * Continues watching, with the full time from now.
   *
   * @throws ScriptError when there is no watchdog
   */
  public void startWatchdog(double nowS) throws ScriptError {
    registered().start(nowS);
  }

  /**
   * Ends watching until it is started again.
   *
   * @throws ScriptError when there is no watchdog
   */
  public void stopWatchdog() throws ScriptError {
    registered().stop();
  }

  private AssemblyWatchdog registered() throws ScriptError {
    return watchdog.orElseThrow(() -> new ScriptError("no-watchdog", text("noWatchdog")));
  }

  /** Ends the handle and its watchdog; the assembly stays as it is. */
  public void close() {
    closed = true;
    watchdog = Optional.empty();
    fields.clear();
  }
}

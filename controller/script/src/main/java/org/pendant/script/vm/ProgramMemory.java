package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.BitSet;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.pendant.script.value.LongOperation;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Program memory: keeps the values of one program within a limit. What is new is added up; the
 * values that are there are only counted when the sum has come near the limit.
 */
final class ProgramMemory {
  /** Bytes of one register. */
  private static final int REGISTER_BYTES = 17;

  /** The part of the limit that new values have to reach at least before all are counted again. */
  private static final int SHARE_BETWEEN_COUNTS = 16;

  /** Smaller values may be counted twice: to look for them would take longer than it is worth. */
  private static final int LARGE_BYTES = 4096;

  private static final double BYTES_A_MB = 1e6;

  private final long limitBytes;
  private long untilCount;

  /**
   * @param limitBytes see {@link Value#sizeBytes}
   */
  ProgramMemory(long limitBytes) {
    this.limitBytes = limitBytes;
    untilCount = limitBytes;
  }

  /** The same limit for another run. */
  ProgramMemory fresh() {
    return new ProgramMemory(limitBytes);
  }

  /**
   * There are values of {@code bytes} more.
   *
   * @param run where all values of the program are
   * @return how many registers were looked at
   * @throws ScriptError when all values together take more than the limit
   */
  int took(long bytes, ProgramRun run) throws ScriptError {
    untilCount -= bytes;
    if (untilCount > 0) {
      return 0;
    }
    forgetOld(run);
    long live = count(run);
    if (live > limitBytes) {
      throw new ScriptError(
          "out-of-memory", text("valuesTooLarge", megabytes(live), megabytes(limitBytes)));
    }
    untilCount = Math.max(limitBytes - live, limitBytes / SHARE_BETWEEN_COUNTS);
    return run.registers().size();
  }

  private static String megabytes(long bytes) {
    return Long.toString((long) Math.ceil(bytes / BYTES_A_MB));
  }

  /** Drops what calls that are over have left in their registers. */
  private static void forgetOld(ProgramRun run) {
    Registers registers = run.registers();
    for (ScriptThread thread : run.threads()) {
      int end = thread.segmentStart + thread.lineSlots;
      for (int i = 0; i < thread.depth; i++) {
        end = Math.max(end, thread.bases[i] + thread.functions[i].slotCount());
      }
      for (int slot = end; slot < thread.segmentEnd; slot++) {
        registers.clear(slot);
      }
    }
    Value[] objects = registers.objects();
    byte[] tags = registers.tags();
    for (int slot = 0; slot < objects.length; slot++) {
      if (tags[slot] != Registers.OBJECT) {
        objects[slot] = null;
      }
    }
  }

  private static long count(ProgramRun run) {
    Registers registers = run.registers();
    long bytes = (long) REGISTER_BYTES * registers.size();
    BitSet dead = new BitSet();
    LiveTemporaries live = new LiveTemporaries(run.tables());
    run.threads().forEach(thread -> dead.or(live.dead(thread, registers)));
    // a temporary and a variable may hold the same value
    Set<Value> large = Collections.newSetFromMap(new IdentityHashMap<>());
    Value[] objects = registers.objects();
    for (int slot = 0; slot < objects.length; slot++) {
      Value object = objects[slot];
      if (object != null && !dead.get(slot)) {
        long size = object.sizeBytes();
        bytes += size < LARGE_BYTES || large.add(object) ? size : 0;
      }
    }
    for (ScriptThread thread : run.threads()) {
      bytes += thread.operation.map(LongOperation::sizeBytes).orElse(0L);
    }
    return bytes;
  }
}

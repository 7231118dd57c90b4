package org.pendant.controller.builtin;

import java.util.Optional;
import org.pendant.controller.box.ToolSerialInterface;
import org.pendant.controller.external.ToolSerialConnector;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.Value;

/**
 * Wait of a script thread until the tool's serial line is set up, so that what it sends next
 * arrives and trouble is logged where it began. A device that takes too long is not waited for.
 */
final class ToolSerialWait implements Wait {
  private static final int MAX_S = 2;

  private final ToolSerialInterface line;
  private final ToolSerialConnector.SetUp setUp;
  private final long deadline;

  /** Waits from frame {@code frame} on. */
  ToolSerialWait(ToolSerialInterface line, ToolSerialConnector.SetUp setUp, long frame) {
    this.line = line;
    this.setUp = setUp;
    deadline = frame + FrameTime.framesFor(MAX_S);
  }

  @Override
  public Optional<Value> poll(long frame) {
    if (!setUp.over() && frame < deadline) {
      return Optional.empty();
    }
    line.step();
    return Optional.of(NoneValue.NONE);
  }

  @Override
  public boolean outside() {
    return true;
  }
}

package org.pendant.controller.device;

import org.pendant.controller.external.Pending;
import org.pendant.script.value.Value;

/** Answered now: the answer of a device that is there at once. */
record AnsweredNow(Value result) implements Pending {
  @Override
  public boolean over() {
    return true;
  }

  @Override
  public boolean inRobotTime() {
    return true;
  }

  @Override
  public void cancel() {}
}

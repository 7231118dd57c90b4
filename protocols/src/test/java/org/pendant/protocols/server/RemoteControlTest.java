package org.pendant.protocols.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class RemoteControlTest {
  @Test
  void withoutTheFeatureEverybodyMayControlAndTheRobotIsNotInRemoteControl() {
    RemoteControl control = RemoteControl.disabled();
    control.setRemote(true);
    assertFalse(control.remote());
    assertTrue(control.mayControl());
  }

  @Test
  void withTheFeatureOnlyInRemoteControl() {
    RemoteControl control = new RemoteControl(true, false);
    assertFalse(control.mayControl());
    control.setRemote(true);
    assertTrue(control.mayControl());
    assertTrue(control.remote());
  }

  @Test
  void tellsWhenRemoteControlEnds() {
    RemoteControl control = new RemoteControl(true, true);
    AtomicInteger told = new AtomicInteger();
    control.onLocal(told::incrementAndGet);
    control.setRemote(false);
    control.setRemote(false);
    control.setRemote(true);
    assertEquals(1, told.get());
  }
}

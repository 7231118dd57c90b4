package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class RemarkTest {
  private static final String SHORT = "Unlocked.";
  private static final String LONG =
      "Changed, not applied yet: the controller still has what was there.";

  private static int height(Remark remark, String sentence) {
    remark.say(sentence);
    remark.setSize(200, 100);
    return remark.getPreferredSize().height;
  }

  @Test
  void aSentenceIsAsHighAsTheLongestOneThatMayTakeItsPlace() {
    Remark alone = new Remark("state", () -> Color.GRAY);
    assertTrue(height(alone, SHORT) < height(alone, LONG));
    Remark remark = new Remark("state", () -> Color.GRAY).withRoomFor(List.of(SHORT, LONG));
    assertEquals(height(alone, LONG), height(remark, SHORT));
    assertEquals(height(alone, LONG), height(remark, LONG));
  }
}

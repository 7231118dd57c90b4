package org.pendant.desktop.shell.chrome;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Pace;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class StatusLineTest {
  private final StatusLine line = new StatusLine(text -> {});

  private String shown() {
    return Stream.of(line.getComponents())
        .filter(each -> "status-text".equals(each.getName()))
        .map(each -> ((JLabel) each).getText().strip())
        .findFirst()
        .orElseThrow();
  }

  private void refresh() {
    line.refresh(new Lateness(0, 0, 0), Pace.REAL_TIME, 0, false);
  }

  @Test
  void aNoticeGoesWhenWhatItSaysIsNoLongerSo() {
    AtomicBoolean incomplete = new AtomicBoolean(true);
    line.tell("a cannot run yet", incomplete::get);
    refresh();
    assertEquals("a cannot run yet", shown());
    incomplete.set(false);
    refresh();
    assertEquals("", shown());
    assertEquals("a cannot run yet", line.text());
  }

  @Test
  void aNoticeThatFollowsStandsWhateverBecomesOfTheOneBefore() {
    line.tell("a cannot run yet", () -> false);
    line.tell("Saved a");
    refresh();
    assertEquals("Saved a", shown());
  }

  @Test
  void nothingElseMovesWhenTheFirstNoticeComes() {
    int heightBefore = line.getPreferredSize().height;
    line.tell("Opened a.pinst");
    assertEquals(heightBefore, line.getPreferredSize().height);
  }
}

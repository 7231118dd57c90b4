package org.pendant.desktop.shell.chrome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Pace;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class StatusLineTest {
  private final List<String> whole = new ArrayList<>();
  private final StatusLine line = new StatusLine(whole::add);

  private String shown() {
    return ((JLabel) part("status-text")).getText().strip();
  }

  private Component part(String name) {
    return Stream.of(line.getComponents())
        .filter(each -> name.equals(each.getName()))
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
  void whoLooksAtWhatWasToldBeforeKeepsTheKeyboardWhereItIs() {
    assertFalse(((JButton) part("status-earlier")).isRequestFocusEnabled());
  }

  @Test
  void whatIsUnderWayStandsUntilSomethingIsToldOfIt() {
    line.tell("Comparing the last run with a.rec\u2026");
    assertFalse(line.fades());
    line.tell("The last run equals a.rec in all 500 frames");
    assertTrue(line.fades());
  }

  @Test
  void theWholeIsOfferedWhenWordsAboutThePaceTakeTheRoom() {
    String notice = "The program never waits, so robot time crawls";
    line.setSize(new JLabel(notice).getPreferredSize().width + 150, 30);
    line.tell(notice);
    assertFalse(part("status-more").isVisible());
    line.showPace("robot time at 49 % of real time: computer busy", "The computer is busy");
    assertTrue(part("status-more").isVisible());
  }

  @Test
  void aClickOnThePaceExplainsIt() {
    JButton pace = (JButton) part("status-frames");
    assertFalse(pace.isVisible());
    line.showPace("robot time at 49 % of real time: computer busy", "The computer is busy");
    assertTrue(pace.isVisible());
    pace.doClick(0);
    assertEquals(List.of("The computer is busy"), whole);
    line.showPace("", "The computer is busy");
    assertFalse(pace.isVisible());
  }

  @Test
  void earlierNoticesAreNoWiderThanTheWindow() {
    line.setSize(1024, 30);
    line.tell("The last run differs: " + "target position; ".repeat(30));
    line.tell("Saved a");
    Component notices = line.earlierNotices();
    assertTrue(notices.getPreferredSize().width < 1050, notices::toString);
  }

  @Test
  void nothingElseMovesWhenTheFirstNoticeComes() {
    int heightBefore = line.getPreferredSize().height;
    line.tell("Opened a.pinst");
    assertEquals(heightBefore, line.getPreferredSize().height);
  }
}

package org.pendant.desktop.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;

final class LogPresenterTest {
  private final List<LogLine> written = new ArrayList<>();

  private void write(Level level, Origin origin, String text) {
    long number = written.size() + 1L;
    written.add(
        LogLine.of(
            number,
            Instant.EPOCH,
            LogSource.of(origin),
            new LogEntry(number, 0.5, level, origin, text)));
  }

  private void say(String... texts) {
    for (String text : texts) {
      write(Level.INFO, Origin.SCRIPT, text);
    }
  }

  private LogPresenter.Change take(LogPresenter presenter) {
    return presenter.take(
        written.size(), number -> List.copyOf(written.subList((int) number, written.size())));
  }

  private static List<String> texts(LogPresenter presenter) {
    List<String> texts = new ArrayList<>();
    for (int row = 0; row < presenter.rows(); row++) {
      texts.add(presenter.row(row).text());
    }
    return texts;
  }

  @Test
  void newMessagesComeAtTheBottomOnce() {
    LogPresenter presenter = new LogPresenter(10);
    say("a", "b");
    assertEquals(new LogPresenter.Change(0, 2), take(presenter));
    assertTrue(take(presenter).none());
    say("c");
    assertEquals(new LogPresenter.Change(0, 1), take(presenter));
    assertEquals(List.of("a", "b", "c"), texts(presenter));
  }

  @Test
  void theOldestGoWhenThereIsNoRoomAndAreCounted() {
    LogPresenter presenter = new LogPresenter(3);
    say("a", "b");
    take(presenter);
    say("c", "d", "e");
    assertEquals(new LogPresenter.Change(2, 3), take(presenter));
    assertEquals(List.of("c", "d", "e"), texts(presenter));
    assertEquals("3 messages, 2 older ones dropped", LogCounts.of(presenter, -1).messages());
  }

  @Test
  void moreNewOnesThanThereIsRoomForReplaceAllRows() {
    LogPresenter presenter = new LogPresenter(3);
    say("a", "b");
    take(presenter);
    say("c", "d", "e", "f", "g");
    assertEquals(new LogPresenter.Change(2, 3), take(presenter));
    assertEquals(List.of("e", "f", "g"), texts(presenter));
  }

  @Test
  void messagesThatWereGoneBeforeTheyWereAskedForAreCounted() {
    LogPresenter presenter = new LogPresenter(10);
    say("a", "b", "c");
    presenter.take(3, number -> written.subList(2, 3));
    assertEquals(2, presenter.missed());
    assertEquals("1 message, 2 missed", LogCounts.of(presenter, -1).messages());
  }

  @Test
  void aFilterShowsOnlySomeSeveritiesAndSources() {
    LogPresenter presenter = new LogPresenter(10);
    say("talk");
    write(Level.WARNING, Origin.CONTROLLER, "hot");
    write(Level.ERROR, Origin.ENDING, "over");
    take(presenter);
    presenter.setFilter(
        new LogFilter(EnumSet.of(Level.WARNING, Level.ERROR), Set.of(LogSource.PROGRAM)));
    assertEquals(List.of("over"), texts(presenter));
    assertEquals("1 of 3 messages", LogCounts.of(presenter, -1).messages());
    presenter.setFilter(LogFilter.ALL);
    assertEquals(List.of("talk", "hot", "over"), texts(presenter));
  }

  @Test
  void aSearchGoesRoundInBothDirections() {
    LogPresenter presenter = new LogPresenter(10);
    say("Grip", "move", "grip again", "end");
    take(presenter);
    presenter.setSearch("GRIP");
    assertEquals(2, presenter.matchCount());
    assertEquals(0, presenter.nextMatch(-1));
    assertEquals(2, presenter.nextMatch(0));
    assertEquals(0, presenter.nextMatch(2));
    assertEquals(2, presenter.previousMatch(0));
    assertEquals(2, presenter.previousMatch(presenter.rows()));
    assertEquals("2 of 2", LogCounts.of(presenter, 2).matches());
  }

  @Test
  void aSearchWithoutMatchesGoesNowhere() {
    LogPresenter presenter = new LogPresenter(10);
    say("a");
    take(presenter);
    presenter.setSearch("b");
    assertEquals(-1, presenter.nextMatch(0));
    assertEquals(-1, presenter.previousMatch(0));
    assertEquals("none found", LogCounts.of(presenter, 0).matches());
  }

  @Test
  void matchesGoWithTheRowsThatAreDropped() {
    LogPresenter presenter = new LogPresenter(2);
    presenter.setSearch("x");
    say("x1", "x2", "x3");
    take(presenter);
    assertEquals(2, presenter.matchCount());
    assertEquals(0, presenter.nextMatch(-1));
  }

  @Test
  void whoReadsAboveSeesHowManyCameBelow() {
    LogPresenter presenter = new LogPresenter(10);
    say("a");
    take(presenter);
    presenter.follow(false);
    say("b", "c");
    take(presenter);
    assertEquals(2, presenter.unread());
    presenter.follow(true);
    assertEquals(0, presenter.unread());
  }

  @Test
  void clearedMessagesDoNotComeBack() {
    LogPresenter presenter = new LogPresenter(10);
    say("a");
    take(presenter);
    presenter.clear();
    say("b");
    take(presenter);
    assertEquals(List.of("b"), texts(presenter));
  }

  @Test
  void aRowKeepsItsPositionWhenOthersAreHidden() {
    LogPresenter presenter = new LogPresenter(10);
    say("talk");
    write(Level.ERROR, Origin.CONTROLLER, "wrong");
    take(presenter);
    long position = presenter.positionOf(1);
    presenter.setFilter(new LogFilter(Set.of(Level.ERROR), LogFilter.ALL.sources()));
    assertEquals(0, presenter.rowAt(position));
  }

  private void sayAt(double timeS, String text) {
    long number = written.size() + 1L;
    written.add(
        LogLine.of(
            number,
            LogLine.NO_WALL,
            LogSource.of(Origin.SCRIPT),
            new LogEntry(number, timeS, Level.INFO, Origin.SCRIPT, text)));
  }

  @Test
  void knowsWhatWasTheNewestAtATimeAndWhatCameLater() {
    LogPresenter presenter = new LogPresenter(10);
    sayAt(1, "a");
    sayAt(2, "b");
    sayAt(3, "c");
    take(presenter);
    assertEquals(1, presenter.lookAt(2.5, -1));
    assertFalse(presenter.later(1));
    assertTrue(presenter.later(2));
    assertEquals(-1, presenter.lookAt(0.5, -1));
    assertTrue(presenter.later(0));
    presenter.lookAtNow();
    assertFalse(presenter.later(2));
  }

  @Test
  void whatWasSelectedBeforeTheLookBackIsSelectedAfterIt() {
    LogPresenter presenter = new LogPresenter(10);
    sayAt(1, "a");
    sayAt(2, "b");
    sayAt(3, "c");
    take(presenter);
    presenter.lookAt(1, 2);
    presenter.lookAt(2, 0);
    assertEquals(2, presenter.lookAtNow());
    presenter.lookAt(1, -1);
    assertEquals(-1, presenter.lookAtNow());
  }

  @Test
  void whatAnotherControllerWroteBeforeIsNotLater() {
    LogPresenter presenter = new LogPresenter(10);
    sayAt(8, "before");
    sayAt(1, "a");
    sayAt(2, "b");
    take(presenter);
    assertEquals(1, presenter.lookAt(1.5, -1));
    assertFalse(presenter.later(0));
    assertTrue(presenter.later(2));
    assertEquals(-1, presenter.lookAt(0.5, -1));
    assertFalse(presenter.later(0));
  }

  @Test
  void startsAgainFromTheFirstMessage() {
    LogPresenter presenter = new LogPresenter(10);
    say("a", "b");
    take(presenter);
    presenter.restart();
    assertEquals(0, presenter.rows());
    take(presenter);
    assertEquals(List.of("a", "b"), texts(presenter));
  }

  @Test
  void whatSafetySaidBeforeIsInTheUnitsThatAreChosenNow() {
    LogPresenter presenter = new LogPresenter(10);
    write(Level.ERROR, Origin.SAFETY, "0.0254 m of way, at 0.5 rad");
    say("went 0.0254 m");
    take(presenter);
    presenter.setSearch("1.0000 in");
    assertEquals("25.40 mm of way, at 28.65\u00b0", presenter.row(0).text());
    assertEquals(0, presenter.matchCount());

    presenter.setForm(new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.VECTOR));

    assertEquals(List.of("1.0000 in of way, at 0.50000 rad", "went 0.0254 m"), texts(presenter));
    assertEquals(1, presenter.matchCount());
  }
}

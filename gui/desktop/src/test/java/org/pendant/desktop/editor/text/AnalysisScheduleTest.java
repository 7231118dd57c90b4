package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;

final class AnalysisScheduleTest {
  private final List<Later> later = new ArrayList<>();
  private final List<String> shown = new ArrayList<>();
  private String text = "x = 1\n";
  private long nowNs;
  private long tickNs;

  private final AnalysisSchedule schedule =
      new AnalysisSchedule(
          (delayMs, work) -> later.add(new Later(delayMs, work)),
          Runnable::run,
          StandardBuiltins.create(),
          "test.script",
          () -> text,
          analysed -> shown.add(analysed.text()),
          () -> nowNs += tickNs);

  private record Later(int delayMs, Runnable work) {}

  private void type(String typed) {
    text += typed;
    schedule.changed();
  }

  private void workOff() {
    while (!later.isEmpty()) {
      later.removeFirst().work.run();
    }
  }

  @Test
  void waitsForAPauseInTyping() {
    type("y");

    assertEquals(AnalysisSchedule.PAUSE_MS, later.getFirst().delayMs);
    assertEquals(List.of(), shown);
    workOff();
    assertEquals(List.of("x = 1\ny"), shown);
  }

  @Test
  void analysesOnceAfterSeveralKeys() {
    type("y");
    type(" ");
    type("=");
    workOff();

    assertEquals(List.of("x = 1\ny ="), shown);
  }

  @Test
  void dropsAResultOfATextThatHasChangedSince() {
    type("y");
    later.removeFirst().work.run(); // the pause is over, the analysis waits for its thread
    type("z");
    later.removeFirst().work.run(); // the analysis of the old text ends

    assertEquals(List.of(), shown);
    assertTrue(schedule.current().isEmpty());
    workOff();
    assertEquals(List.of("x = 1\nyz"), shown);
  }

  @Test
  void doesNotReadATextThatHasChangedBeforeItsTurn() {
    type("y");
    later.removeFirst().work.run(); // the pause is over, the analysis waits for its thread
    type("z");
    int dispatched = later.size();
    later.removeFirst().work.run(); // its turn comes: there is nothing to hand over

    assertEquals(dispatched - 1, later.size());
  }

  @Test
  void restsAfterALongAnalysis() {
    tickNs = 50_000_000; // an analysis looks at the clock twice: it takes 50 ms
    schedule.whenCurrent(analysed -> {});
    later.removeFirst().work.run();
    type("y");
    later.clear();
    schedule.whenDue(analysed -> {});

    assertEquals(150, later.getFirst().delayMs, "of the 200 ms some have passed");
    later.clear();
    schedule.whenCurrent(analysed -> {});
    assertEquals(0, later.getFirst().delayMs, "a request does not wait");
  }

  @Test
  void hurriesNothingForWhoeverCanWait() {
    List<String> received = new ArrayList<>();
    type("y");
    schedule.whenRested(analysed -> received.add(analysed.text()));

    assertEquals(1, later.size());
    workOff();
    assertEquals(List.of("x = 1\ny"), received);
  }

  @Test
  void analysesAtOnceWhenSomebodyWaits() {
    List<String> received = new ArrayList<>();
    type("y");
    later.clear();
    schedule.whenCurrent(analysed -> received.add(analysed.text()));

    assertEquals(0, later.getFirst().delayMs);
    workOff();
    assertEquals(List.of("x = 1\ny"), received);
  }

  @Test
  void answersAtOnceFromTheResultThatThereIs() {
    List<String> received = new ArrayList<>();
    type("y");
    workOff();
    schedule.whenCurrent(analysed -> received.add(analysed.text()));

    assertEquals(List.of("x = 1\ny"), received);
    assertEquals(List.of(), later);
  }

  @Test
  void forgetsWhoWaitsWhenTheTextChanges() {
    List<String> received = new ArrayList<>();
    schedule.whenCurrent(analysed -> received.add(analysed.text()));
    type("y");
    workOff();

    assertEquals(List.of(), received);
  }
}

package org.pendant.desktop.waveform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.InputChange;

final class WaveRowTest {
  private static final String INPUT = "digital_in[0]";

  private static WaveRow row(double... edgesS) {
    WaveRow row = WaveRow.idle(INPUT);
    for (double edgeS : edgesS) {
      row = row.with(edgeS, row.opposite(edgeS));
    }
    return row;
  }

  private static List<Double> times(WaveRow row) {
    return row.changes().stream().map(InputChange::timeS).toList();
  }

  @Test
  void aClickChangesTheLevelUpToTheNextChange() {
    WaveRow row = row(2);
    assertEquals(List.of(0.0, 2.0), times(row));
    assertEquals(List.of(0.0, 1.0), times(row.with(1, "true")), "high from 1 s on, without a gap");
    assertEquals(List.of(0.0, 2.0, 3.0), times(row.with(3, "false")));
  }

  @Test
  void aStretchLeavesWhatIsAroundIt() {
    WaveRow pulse = row().with(1, 2, "true");
    assertEquals(List.of(0.0, 1.0, 2.0), times(pulse));
    assertFalse(pulse.high(0.999));
    assertTrue(pulse.high(1));
    assertFalse(pulse.high(2));
    assertEquals(List.of(0.0, 1.0, 3.0), times(pulse.with(2, 3, "true")), "one longer pulse");
    assertEquals(List.of(0.0), times(pulse.with(0.5, 2.5, "false")), "the pulse is gone");
  }

  @Test
  void beforeTheFirstChangeTheInputIsLeftAsItIs() {
    WaveRow row = new WaveRow(INPUT, List.of(new InputChange(1, INPUT, "true")));
    assertEquals(Optional.empty(), row.at(0.5));
    assertEquals(Optional.of("true"), row.at(1));
    assertEquals(List.of(0.2, 0.4, 1.0), times(row.with(0.2, 0.4, "true")));
  }

  @Test
  void aChangeMovesBetweenItsNeighbours() {
    WaveRow row = row(1, 2, 3);
    assertEquals(List.of(0.0, 1.0, 2.5, 3.0), times(row.moved(2, 2.5, 0.002)));
    assertEquals(List.of(0.0, 1.0, 2.998, 3.0), times(row.moved(2, 9, 0.002)));
    assertEquals(List.of(0.0, 1.0, 1.002, 3.0), times(row.moved(2, -9, 0.002)));
  }

  @Test
  void withoutAChangeTheLevelBeforeLasts() {
    assertEquals(List.of(0.0, 3.0), times(row(1, 2, 3).without(1)));
  }

  @Test
  void inputsWithNumbersTakeValuesAndRefuseOthers() {
    WaveRow analog = WaveRow.idle("analog_in[0]").with(1, "7.5V");
    assertFalse(analog.level());
    assertEquals(Optional.of("0V"), analog.at(0));
    assertEquals(Optional.of("7.5V"), analog.at(5));
    assertThrows(IllegalArgumentException.class, () -> analog.with(2, "11V"));
    assertThrows(IllegalArgumentException.class, () -> WaveRow.idle("digital_out[0]"));
  }

  /** Whatever is drawn: inside it is there, outside all is as before, and no change is idle. */
  @Test
  void drawingChangesNothingElse() {
    Random random = new Random(3);
    WaveRow row = row();
    for (int i = 0; i < 500; i++) {
      WaveRow before = row;
      double fromS = random.nextInt(100) / 10.0;
      double toS = fromS + (1 + random.nextInt(20)) / 10.0;
      String value = Boolean.toString(random.nextBoolean());
      row = before.with(fromS, toS, value);
      for (double timeS = 0.05; timeS < 13; timeS += 0.1) {
        String expected = timeS >= fromS && timeS < toS ? value : before.at(timeS).orElseThrow();
        assertEquals(expected, row.at(timeS).orElseThrow());
      }
      for (int k = 1; k < row.changes().size(); k++) {
        assertTrue(row.changes().get(k).timeS() > row.changes().get(k - 1).timeS());
      }
    }
  }

  @Test
  void aSheetPlaysWhatComesBeforeItsPeriodIsOver() {
    WaveSheet sheet =
        WaveSheet.EMPTY.plus(row(1, 2, 5)).plus(WaveRow.idle("tool_in[1]").with(3, "true"));
    assertEquals(sheet, WaveSheet.of(sheet.waveforms()));
    WaveSheet short4 = sheet.repeating(OptionalDouble.of(4));
    assertEquals(5, short4.waveforms().changes().size());
    assertEquals(OptionalDouble.of(4), short4.waveforms().periodS());
  }

  @Test
  void stepsAreTakenBackAndMadeAgain() {
    WaveformDraft draft = new WaveformDraft(new WaveformDraft.Steps(WaveSheet.EMPTY));
    WaveSheet one = WaveSheet.EMPTY.plus(row(1));
    draft.set(one);
    draft.set(one.with(0, row(2)));
    draft.undo();
    assertEquals(one, draft.sheet());
    draft.undo();
    assertEquals(WaveSheet.EMPTY, draft.sheet());
    assertFalse(draft.canUndo());
    draft.redo();
    assertEquals(one, draft.sheet());
    draft.set(one.without(0));
    assertFalse(draft.canRedo());
  }
}

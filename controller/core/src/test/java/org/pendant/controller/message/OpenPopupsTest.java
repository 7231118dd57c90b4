package org.pendant.controller.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.Popup.Severity;

final class OpenPopupsTest {
  private final MessageLog log = new MessageLog();

  private OpenPopups board(Operator operator) {
    return new OpenPopups(operator, log, new PromptNumbers());
  }

  @Test
  void aPersonAnswersByNumber() {
    OpenPopups board = board(Operator.present());
    Popup first = board.show(0, "Popup", "one", Severity.MESSAGE, true);
    Popup second = board.show(0, "Popup", "two", Severity.ERROR, false);
    assertEquals(List.of(first, second), board.open());
    assertTrue(board.blocked());
    assertTrue(board.answer(first.number()));
    assertFalse(board.answer(first.number()));
    assertFalse(board.blocked());
    assertEquals(List.of(second), board.open());
  }

  @Test
  void withoutAScreenEveryPopupIsShownAndAnswered() {
    OpenPopups board = board(Operator.headless(List.of()));
    Popup popup = board.show(0, "Popup", "one", Severity.MESSAGE, true);
    assertFalse(board.isOpen(popup));
    assertEquals(List.of(popup), board.takeNew());
    assertEquals(List.of(), board.takeNew());
  }

  @Test
  void theScreenHoldsABoundedNumberAndSaysWhatWentUnread() {
    OpenPopups board = board(Operator.present());
    Popup blocking = board.show(0, "Popup", "stay", Severity.MESSAGE, true);
    for (int i = 0; i < 1000; i++) {
      board.show(0, "Part", "number " + i, Severity.MESSAGE, false);
      board.takeNew();
    }
    assertTrue(board.isOpen(blocking));
    assertTrue(board.open().size() < 100);
    assertTrue(log.since(0).getFirst().text().endsWith("Part: number 0"));
  }

  @Test
  void aFrameShowsSixteenAndTheLogSaysHowManyMoreThereWere() {
    OpenPopups board = board(Operator.present());
    for (int i = 0; i < 20; i++) {
      board.show(0, "Part", "number " + i, Severity.MESSAGE, false);
    }
    assertEquals(16, board.takeNew().size());
    assertEquals("4 more popups were not shown in this frame", log.since(0).getFirst().text());
  }

  @Test
  void aLongTextIsCutAndSaysHowLongItWas() {
    Popup shown =
        board(Operator.present()).show(0, "Popup", "x".repeat(5000), Severity.MESSAGE, false);
    assertEquals(OpenPopups.MAX_TEXT, shown.text().length());
    assertTrue(shown.text().endsWith("(cut, 5000 bytes in all)"));
  }

  @Test
  void oneThatBlocksIsNeverDropped() {
    OpenPopups board = board(Operator.present());
    for (int i = 0; i < 200; i++) {
      board.show(0, "Popup", "stay", Severity.MESSAGE, true);
    }
    assertEquals(200, board.open().size());
  }
}

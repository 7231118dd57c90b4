package org.pendant.controller.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.Popup.Severity;

final class PopupBoardTest {
  @Test
  void aPersonAnswersByNumber() {
    PopupBoard board = new PopupBoard(Operator.present());
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
    PopupBoard board = new PopupBoard(Operator.headless(Map.of("name", "x")));
    Popup popup = board.show(0, "Popup", "one", Severity.MESSAGE, true);
    assertFalse(board.isOpen(popup));
    assertEquals(List.of(popup), board.takeNew());
    assertEquals(List.of(), board.takeNew());
    assertEquals(Optional.of("x"), board.operator().answerTo("name"));
    assertEquals(Optional.empty(), board.operator().answerTo("age"));
  }

  @Test
  void theScreenHoldsABoundedNumberAndDropsThoseThatDoNotBlock() {
    PopupBoard board = new PopupBoard(Operator.present());
    Popup blocking = board.show(0, "Popup", "stay", Severity.MESSAGE, true);
    for (int i = 0; i < 1000; i++) {
      board.show(0, "Popup", "more", Severity.MESSAGE, false);
    }
    assertTrue(board.isOpen(blocking));
    assertTrue(board.open().size() < 100);
  }
}

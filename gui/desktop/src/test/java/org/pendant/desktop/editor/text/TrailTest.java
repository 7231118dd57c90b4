package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;

final class TrailTest {
  private final Trail<String> trail = new Trail<>();

  @Test
  void jumpsAreGoneBackAndForward() {
    trail.left("a");
    trail.left("b");
    assertEquals(Optional.of("b"), trail.back("c"));
    assertEquals(Optional.of("a"), trail.back("b"));
    assertEquals(Optional.empty(), trail.back("a"));
    assertEquals(Optional.of("b"), trail.forward("a"));
    assertEquals(Optional.of("c"), trail.forward("b"));
    assertEquals(Optional.empty(), trail.forward("c"));
  }

  @Test
  void aNewJumpForgetsWhatWasAhead() {
    trail.left("a");
    trail.back("b");
    trail.left("a");
    assertEquals(Optional.empty(), trail.forward("d"));
  }

  @Test
  void thePresentPlaceIsPassed() {
    trail.left("a");
    trail.left("b");
    assertEquals(Optional.of("a"), trail.back("b"));
  }
}

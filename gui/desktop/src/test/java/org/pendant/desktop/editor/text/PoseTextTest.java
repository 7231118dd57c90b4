package org.pendant.desktop.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;

final class PoseTextTest {
  @Test
  void aPoseIsReadAsScriptsPrintIt() {
    assertEquals(
        Optional.of(new Pose(0.4, -0.3, 1e-5, 0, 3.14, 0)),
        PoseText.read("p[0.4, -0.3, 1e-05, 0, 3.14, 0]"));
  }

  @Test
  void otherValuesAreNone() {
    assertEquals(Optional.empty(), PoseText.read("[0.4, -0.3, 0.2, 0, 3.14, 0]"));
    assertEquals(Optional.empty(), PoseText.read("p[0.4, -0.3, 0.2, 0, 3.14]"));
    assertEquals(Optional.empty(), PoseText.read("p[0.4, -0.3, 0.2, 0, nan, 0]"));
    assertEquals(Optional.empty(), PoseText.read("[p[0.4, -0.3, 0.2, 0, 3.14, 0], 1]"));
    assertEquals(Optional.empty(), PoseText.read(""));
  }
}

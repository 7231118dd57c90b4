package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.project.program.NodeKind;

final class StepIconTest {
  @ParameterizedTest
  @EnumSource
  void everyKindOfNodeHasADrawing(NodeKind kind) {
    assertTrue(StepIcon.of(kind).hasFound());
  }

  @ParameterizedTest
  @EnumSource
  void everyToolOfTheTreeHasADrawing(TreeTool tool) {
    assertTrue(tool.icon().hasFound());
  }
}

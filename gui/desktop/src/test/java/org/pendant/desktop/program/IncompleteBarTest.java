package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.check.NodeProblem;

final class IncompleteBarTest {
  @Test
  void everyLineOfTheListCanBeRead() {
    IncompleteBar bar = new IncompleteBar(key -> key == 0 ? "" : "Set", problem -> {});
    bar.show(
        List.of(new NodeProblem(3, "payload", "no payload"), new NodeProblem(4, "", "no TCP")));
    int folded = bar.getPreferredSize().height;
    bar.unfold(true);
    int lines = bar.getFontMetrics(bar.getFont()).getHeight() * 2;
    assertTrue(bar.getPreferredSize().height >= folded + lines, () -> bar.getPreferredSize() + "");
  }
}

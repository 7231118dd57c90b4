package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Set;
import javax.swing.JList;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.project.program.check.NodeProblem;

@OnDispatchThread
final class TreeCellTest {
  private static final int WIDE = 200;
  private static final int HIGH = 24;

  /** A tree without problems and marks. */
  private static final class Plain implements TreeCell.TreeLooks {
    @Override
    public TreeMarks marks() {
      return TreeMarks.NONE;
    }

    @Override
    public int digits() {
      return 2;
    }

    @Override
    public List<NodeProblem> problems(long key) {
      return List.of();
    }

    @Override
    public boolean found(long key) {
      return false;
    }

    @Override
    public String label(TreeRow row) {
      return "Feeder";
    }
  }

  @Test
  void selectionLeavesTheMarginToTheMarksOfBreakpointsAndExecution() {
    FlatLaf.setup(new FlatLightLaf());
    JList<TreeRow> list = new JList<>();
    TreeRow row = TreeRow.of(Trees.of(Trees.waypoint("Feeder")), Set.of()).getLast();
    TreeCell cell = new TreeCell(new Plain());
    cell.getListCellRendererComponent(list, row, 1, true, true);
    cell.setSize(WIDE, HIGH);
    BufferedImage picture = new BufferedImage(WIDE, HIGH, BufferedImage.TYPE_INT_RGB);
    picture.createGraphics().fillRect(0, 0, WIDE, HIGH);
    cell.paint(picture.createGraphics());

    assertEquals(Color.WHITE.getRGB(), picture.getRGB(TreeCell.margin() / 2, HIGH / 2));
    assertNotEquals(Color.WHITE.getRGB(), picture.getRGB(WIDE - 4, HIGH / 2));
  }
}

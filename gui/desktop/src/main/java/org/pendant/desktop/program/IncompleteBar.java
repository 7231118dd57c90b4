package org.pendant.desktop.program;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongFunction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;

/**
 * Incomplete program bar: what keeps the program from running, below the tree: a line, and on
 * demand all of it.
 */
@SuppressWarnings("serial") // never written to a stream
final class IncompleteBar extends JPanel {
  private static final int MAX_ROWS = 6;

  private final JToggleButton heading = new JToggleButton();
  private final JList<NodeProblem> list =
      new JList<>() {
        @Override
        public boolean getScrollableTracksViewportWidth() {
          return true;
        }
      };
  private final JScrollPane scroll = new JScrollPane(list);
  private final transient LongFunction<String> label;

  /**
   * Nothing is wrong yet.
   *
   * @param label what a node is called
   * @param chosen goes to what has to be changed
   */
  IncompleteBar(LongFunction<String> label, Consumer<NodeProblem> chosen) {
    super(new BorderLayout());
    this.label = label;
    setName("program-problems-bar");
    heading.setName("program-problems-toggle");
    heading.putClientProperty("JButton.buttonType", "toolBarButton");
    heading.setHorizontalAlignment(JToggleButton.LEADING);
    heading.setToolTipText(ProgramViewTexts.text("showsWhatHasToBeDone"));
    heading.addActionListener(event -> unfold(heading.isSelected()));
    list.setName("program-problems");
    list.getAccessibleContext()
        .setAccessibleName(ProgramViewTexts.text("whatKeepsTheProgramFromRunning"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Cell());
    Runnable choose =
        () -> {
          if (list.getSelectedValue() != null) {
            chosen.accept(list.getSelectedValue());
          }
        };
    list.registerKeyboardAction(
        event -> choose.run(), KeyStroke.getKeyStroke("ENTER"), JComponent.WHEN_FOCUSED);
    list.addMouseListener(
        new java.awt.event.MouseAdapter() {
          @Override
          public void mouseClicked(java.awt.event.MouseEvent event) {
            choose.run();
          }
        });
    add(heading, BorderLayout.NORTH);
    add(scroll);
    scroll.setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Palette.line()));
    scroll.setVisible(false);
    setVisible(false);
  }

  void show(List<NodeProblem> problems) {
    // All lines are as high as one: otherwise each change of a long program would look at all.
    list.setPrototypeCellValue(null);
    list.setPrototypeCellValue(new NodeProblem(ProgramTree.ROOT, "", "Xy"));
    list.setListData(problems.toArray(new NodeProblem[0]));
    list.setVisibleRowCount(Math.clamp(problems.size(), 1, MAX_ROWS));
    heading.setText(
        problems.size() == 1
            ? ProgramViewTexts.text("thingToComplete")
            : ProgramViewTexts.text("thingsToComplete", problems.size()));
    heading.setForeground(Palette.warning());
    setVisible(!problems.isEmpty());
    if (problems.isEmpty()) {
      unfold(false);
    }
    revalidate();
  }

  /** Shows all of it, or only the line. */
  void unfold(boolean wanted) {
    heading.setSelected(wanted);
    scroll.setVisible(wanted);
    revalidate();
  }

  /** Goes to the list. */
  void focus() {
    list.setSelectedIndex(0);
    list.requestFocusInWindow();
  }

  @Override
  public Dimension getMinimumSize() {
    return new Dimension(UIScale.scale(60), heading.getPreferredSize().height);
  }

  /** A message that begins with the name of its node needs that once. */
  private String text(NodeProblem problem) {
    String name = label.apply(problem.key());
    String message = Messages.shown(problem.message());
    return message.startsWith(name) ? message : Messages.told(name, message);
  }

  /** Node and message. */
  private final class Cell extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> from, Object value, int index, boolean selected, boolean focused) {
      String text = value instanceof NodeProblem problem ? text(problem) : "";
      super.getListCellRendererComponent(from, text, index, selected, focused);
      setToolTipText(text);
      return this;
    }
  }
}

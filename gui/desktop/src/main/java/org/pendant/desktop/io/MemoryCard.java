package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.Dimension;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.layout.InnerScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Memory card: the registers of one kind and direction, or the flags. */
final class MemoryCard {
  private static final int MAX_ROWS = 8;

  private final TitledCard card;
  private final MemoryList list;
  private final MemoryTable table;
  private final JScrollPane scroll;
  private final JLabel empty = new JLabel();
  private final JLabel problem = new JLabel();
  private boolean problemShown;

  MemoryCard(Memory memory, Forcing forcing, SignalLabels labels) {
    list = new MemoryList(memory, forcing, labels);
    card = new TitledCard(memory.id(), Messages.shown(memory.title()), "[grow,fill]");
    String name = memory.id();
    table = new MemoryTable("io-" + name, list, this::tell);
    scroll =
        new JScrollPane(
            table,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER) {
          @Override
          public Dimension getPreferredSize() {
            int rows = Math.clamp(table.getRowCount(), 1, MAX_ROWS);
            int titles = table.getTableHeader().getPreferredSize().height;
            int height = titles + rows * table.getRowHeight();
            Insets insets = getInsets();
            return new Dimension(0, height + insets.top + insets.bottom);
          }
        };
    empty.setEnabled(false);
    problem.setName("io-" + name + "-problem");
    problem.setBorder(BorderFactory.createEmptyBorder(0, 8, 0, 8));
    InnerScroll.of(scroll);
    card.add(scroll, "wmin 0");
    card.add(empty, "w 0:0:");
    showRows();
  }

  private void tell(String text) {
    problem.setText(text);
    problem.setToolTipText(text.isEmpty() ? null : text);
    problem.setForeground(Palette.error());
    // in place of the titles, so that nothing moves away below the user who types
    problem.setPreferredSize(new Dimension(0, table.getTableHeader().getPreferredSize().height));
    boolean wrong = !text.isEmpty();
    if (wrong != problemShown && scroll.getColumnHeader() != null) {
      problemShown = wrong;
      scroll.setColumnHeaderView(wrong ? problem : table.getTableHeader());
    }
  }

  JComponent component() {
    return card;
  }

  /** Shows what is looked for, see {@link MemoryList#filter}. */
  void filter(String text, boolean inUse) {
    if (table.isEditing()) {
      table.getCellEditor().cancelCellEditing();
    }
    list.filter(text, inUse);
    empty.setText(text.isBlank() ? text("thoseInUseOrWithA") : text("noneHasThisNumberOrName"));
    showRows();
  }

  private void showRows() {
    if (table.showNewest() || scroll.isVisible() != table.getRowCount() > 0) {
      scroll.setVisible(table.getRowCount() > 0);
      empty.setVisible(table.getRowCount() == 0);
      card.revalidate();
    }
  }

  void refresh(ControllerState state) {
    list.take(state);
    showRows();
  }
}

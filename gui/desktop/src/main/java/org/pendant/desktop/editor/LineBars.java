package org.pendant.desktop.editor;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.Map;
import javax.swing.JPanel;

/** Line bars: beside the text the gutter, what tests have reached, and how warm lines are. */
@SuppressWarnings("serial") // never written to a stream
final class LineBars extends JPanel {
  private final ScriptArea area;
  private final CoverBar cover;
  private final HeatBar heat;

  LineBars(ScriptArea area, Component gutter) {
    super(new BorderLayout());
    this.area = area;
    cover = new CoverBar(area);
    heat = new HeatBar(area, area.notes());
    JPanel bars = new JPanel(new BorderLayout());
    bars.add(cover, BorderLayout.LINE_START);
    bars.add(heat, BorderLayout.LINE_END);
    add(gutter);
    add(bars, BorderLayout.LINE_END);
  }

  /** Shows what stands behind lines. */
  void showNotes(Map<Integer, LineNote> notes) {
    area.notes().set(notes);
    heat.repaint();
  }

  /** What tests have reached. */
  CoverBar cover() {
    return cover;
  }
}

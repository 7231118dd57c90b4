package org.pendant.desktop.editor;

import javax.swing.JPopupMenu;
import org.pendant.desktop.session.ProgramDocument;

/** Margin menu: what can be done beside a line of a program. */
@FunctionalInterface
public interface MarginMenu {
  /** The menu of a line, counted from 1. */
  JPopupMenu of(ProgramDocument program, int line);
}

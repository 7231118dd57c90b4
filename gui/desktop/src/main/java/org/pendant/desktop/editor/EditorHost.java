package org.pendant.desktop.editor;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import javax.swing.JPopupMenu;
import org.pendant.desktop.editor.text.Place;
import org.pendant.desktop.unit.PoseForm;

/** Editor host: the requests of a program's editor to the view around it. */
interface EditorHost {

  /** Says a sentence at the edge of the window. */
  void tell(String sentence);

  /** Does an action of the window. */
  void run(String action);

  /** Lists places under a title. */
  void list(String title, List<Place> places);

  /** There is a new analysis, or the caret stands elsewhere. */
  void changed(ProgramEditor editor);

  /** Other lines have breakpoints. */
  void breakpointsChanged(ProgramEditor editor);

  /** Breakpoints have moved with the text: where each line with one is now. */
  void breakpointsMoved(ProgramEditor editor, SortedMap<Integer, Integer> moves);

  /** What a variable is now, or was last; empty if that is not known. */
  Optional<String> value(ProgramEditor editor, String name);

  /** In which units numbers are shown. */
  PoseForm units();

  /** What can be done beside a line. */
  JPopupMenu marginMenu(ProgramEditor editor, int line);

  /** The program is being closed. */
  void ending(ProgramEditor editor);

  /** The user is about to jump away from the caret's place. */
  void leaving(ProgramEditor editor);
}

package org.pendant.desktop.editor;

/** A panel that follows the editor. */
interface EditorListener {

  /** There is a new analysis of the program in front, another program, or another caret. */
  void editorChanged();
}

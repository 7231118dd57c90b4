package org.pendant.desktop.editor;

/** Editor listener: a panel that follows the editor. */
interface EditorListener {

  /** There is a new analysis of the program in front, another program, or another caret. */
  void editorChanged();
}

package org.pendant.desktop.shell;

/** Shows a place of the current program. */
@FunctionalInterface
interface SourcePlace {

  /** Lines and columns count from 1. */
  void show(int line, int column);
}

package org.pendant.desktop.shell;

/** Source location: shows a place of the current program. */
@FunctionalInterface
interface SourcePlace {

  /** Lines and columns count from 1. */
  void show(int line, int column);
}

package org.pendant.desktop.scene;

/** Lens: how depth is shown. */
public enum Lens {
  /** As an eye sees it: what is far is small. */
  PERSPECTIVE,
  /** As a drawing shows it: what is parallel stays parallel, and lengths can be compared. */
  ORTHOGRAPHIC;

  /** The one that is not this. */
  public Lens other() {
    return this == PERSPECTIVE ? ORTHOGRAPHIC : PERSPECTIVE;
  }
}

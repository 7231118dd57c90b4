package org.pendant.controller.quantity;

/**
 * Component: one number of a quantity.
 *
 * @param name stable name in settings and files, such as {@code actual_q_0}
 * @param words what people read beside the others of its group
 * @param unit what it counts
 */
public record Component(String name, QuantityTitle words, PhysicalUnit unit) {
  /** What people read beside the others of its group, such as {@code Base}. */
  public String title() {
    return words.text();
  }
}

package org.pendant.controller.quantity;

/**
 * Quantity title: what people read of a quantity, a component or a group. Its text is read when
 * somebody asks for it: every run needs the catalogue, and few show what its entries are called.
 *
 * @param key of the text; empty for a name that is no text, such as that of an axis or a signal
 * @param value the name itself, or what stands for {@code {0}} in the text
 */
public record QuantityTitle(String key, String value) {
  /** A text without a value. */
  static QuantityTitle of(String key) {
    return of(key, "");
  }

  static QuantityTitle of(String key, Object value) {
    return new QuantityTitle(key, value.toString());
  }

  /** A name as it is. */
  static QuantityTitle named(String name) {
    return new QuantityTitle("", name);
  }

  /** It in English. */
  public String text() {
    return key.isEmpty() ? value : QuantityTexts.text(key, value);
  }
}

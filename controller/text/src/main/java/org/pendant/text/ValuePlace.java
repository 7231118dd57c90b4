package org.pendant.text;

/**
 * Where a text takes a value.
 *
 * @param number 0 to 9
 * @param isText whether the value is a text itself, which a translation says in its language too
 */
record ValuePlace(int number, boolean isText) {}

package org.pendant.motion.toolpath.nc;

/**
 * Word of a toolpath file: a letter with its number.
 *
 * @param letter in upper case
 * @param text as it stands in the file
 */
record NcWord(char letter, double number, String text) {
  /** Whether the number is {@code code} exactly. */
  boolean is(int code) {
    return number == code;
  }
}

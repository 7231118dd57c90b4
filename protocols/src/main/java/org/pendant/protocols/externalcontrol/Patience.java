package org.pendant.protocols.externalcontrol;

/**
 * Time limits of drivers: how long one may take.
 *
 * @param connectMs until it has taken the connection, for each address of its host, ms
 * @param answerMs until it begins to answer, or continues with a line, ms
 * @param quietMs after which a text that ends with a line end is taken to be whole, ms
 * @param longestMs for everything together, ms
 */
record Patience(int connectMs, int answerMs, int quietMs, int longestMs) {
  /**
   * The first two are those of the URCap. It takes as whole what has come so far when it has read a
   * line; a quarter of a second more lets a lost packet come again.
   */
  static final Patience STANDARD = new Patience(5_000, 500, 250, 10_000);
}

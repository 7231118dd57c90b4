/**
 * Values a running script computes with, and how they print. Open {@link
 * org.pendant.script.value.Value} first; {@link org.pendant.script.value.Operators} holds what the
 * operators do beyond plain numbers.
 */
package org.pendant.script.value;

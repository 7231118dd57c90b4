/**
 * The values a running script computes with, and how they print. Open {@link
 * org.pendant.controller.value.Value} first; {@link org.pendant.controller.value.Operators} holds
 * what the operators do beyond plain numbers.
 */
package org.pendant.controller.value;

/**
 * Text of numbers in messages and in scripts; begin with {@link org.pendant.models.text.FloatText}.
 */
package org.pendant.models.text;

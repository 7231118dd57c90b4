/**
 * How numbers read in messages and in scripts; begin with {@link
 * org.pendant.models.text.NumberText}.
 */
package org.pendant.models.text;

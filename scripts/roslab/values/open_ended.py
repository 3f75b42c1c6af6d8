"""What says after a version, in other languages than English, that later ones will do, too: ``3.6 及以上版本``."""

from __future__ import annotations

OF_LANGUAGES = (
    r"[\s,]{0,2}(?:\(|\uff08)?(?:[及或和与]?\s?(?:以上|(?:以后|之后)的?版本)|[及或和与]\s?(?:以后|之后|更高|更新)|或后续|以降|이상|もしくはそれ以降|"
    r"(?:o|ó|y|e|ou|et|oder|und|или|и)\s(?:superior|posterior|más|mayor|supérieur|plus\srécent|ultérieur|"
    r"höher|neuer|später|выше|новее|maior|mais\srecente|successiv))"
)
"""Chinese, Japanese, Korean, Spanish, Portuguese, Italian, French, German and Russian. By themselves, 之后 says what
comes after (``安装 Ubuntu 18.04 之后``), and 更新 what is updated (``Ubuntu 18.04 更新源``)."""
